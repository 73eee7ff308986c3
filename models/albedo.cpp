#include "models/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "models/spherical.h"

namespace scanlit::models {
namespace {

using std::numbers::pi;

// The integrand's two coordinates: the half vector is at the polar angle t, 0 at the normal, and at
// the azimuth p from the viewer's. l is above the horizon where t < t_max(p); s = t / t_max makes a
// rectangle of that, so that the horizon is an edge of the domain and not a jump inside of it.
class HalfVectors {
 public:
  explicit HalfVectors(const Vec3<double>& v)
      : v_(v), theta_(std::atan2(std::hypot(v.x, v.y), v.z)), azimuth_(std::atan2(v.y, v.x)) {}

  struct Point {
    Vec3<double> l;
    double area;  // solid angle of l for a unit of (s, p)
  };

  // l = 2 (v.h) h - v and dl = 4 (v.h) dh; dh = sin t dt dp.
  Point at(double s, double p) const {
    const double t_max = this->t_max(p), t = t_max * s;
    const Vec3<double> h = spherical_direction(t, p + azimuth_);
    const double v_h = dot(v_, h);
    return {(2 * v_h) * h - v_, std::max(0.0, 4 * v_h * std::sin(t) * t_max)};
  }

  // (s, p) of the half vector of l, p in -pi..pi.
  std::array<double, 2> of(const Vec3<double>& l) const {
    const Vec3<double> h = l + v_;
    const double t = std::atan2(std::hypot(h.x, h.y), h.z);
    const double p = t > 0 ? std::remainder(std::atan2(h.y, h.x) - azimuth_, 2 * pi) : 0;
    return {std::min(1.0, t / t_max(p)), p};
  }

  double azimuth() const { return azimuth_; }

 private:
  // In terms of a with tan a = tan(theta_v) cos p: l.z > 0 is cos(2 t - a) > 0.
  double t_max(double p) const {
    return pi / 4 + 0.5 * std::atan2(std::sin(theta_) * std::cos(p), std::cos(theta_));
  }

  Vec3<double> v_;
  double theta_, azimuth_;
};

Rgb<double> magnitude(const Rgb<double>& a) {
  return {std::abs(a.r), std::abs(a.g), std::abs(a.b)};
}
double largest(const Rgb<double>& a) { return std::max({a.r, a.g, a.b}); }

// The 15-point rule of Kronrod and the 7-point rule of Gauss within it, as in QUADPACK's qk15
// (Piessens et al. 1983); nodes from 1 to 0, the other half mirrors them.
constexpr double node[8] = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144838258730, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0};
constexpr double kronrod[8] = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
constexpr double gauss[8] = {
    0, 0.129484966168869693270611432679082, 0, 0.279705391489276667901467771423780,
    0, 0.381830050505118944950369775488975, 0, 0.417959183673469387755102040816327};
constexpr int points = 15;

double node_at(int i) { return i < 8 ? -node[i] : node[14 - i]; }
double weight_at(const double (&rule)[8], int i) { return rule[i < 8 ? i : 14 - i]; }

struct Cell {
  std::array<double, 2> low, high;  // in (s, p)
  Rgb<double> value, error;
  int widest_error = 0;  // the axis along which the two rules disagree more
  bool operator<(const Cell& other) const { return largest(error) < largest(other.error); }
};

// Kronrod's rule on both axes is the value. Along each axis its difference from Gauss's rule, which
// is far less accurate, is that axis' error: an overestimate wherever the integrand is smooth.
void integrate(const ReflectionModel& model, const Vec3<double>& v, const HalfVectors& domain,
               Cell& cell) {
  Rgb<double> both, gauss_s, gauss_p;
  const auto at = [&](int axis, int i) {
    return 0.5 *
           (cell.low[axis] + cell.high[axis] + (cell.high[axis] - cell.low[axis]) * node_at(i));
  };
  for (int i = 0; i < points; ++i) {
    Rgb<double> row, gauss_row;
    for (int j = 0; j < points; ++j) {
      const auto [l, area] = domain.at(at(0, i), at(1, j));
      const Reflection<double> value = model.evaluate(l, v);
      const Rgb<double> f = (value.diffuse + value.glossy) * area;
      row = row + f * weight_at(kronrod, j);
      gauss_row = gauss_row + f * weight_at(gauss, j);
    }
    both = both + row * weight_at(kronrod, i);
    gauss_s = gauss_s + row * weight_at(gauss, i);
    gauss_p = gauss_p + gauss_row * weight_at(kronrod, i);
  }
  // A model returns pi f_r (n.l).
  const double scale = (cell.high[0] - cell.low[0]) * (cell.high[1] - cell.low[1]) / (4 * pi);
  const Rgb<double> error_s = magnitude(both - gauss_s), error_p = magnitude(both - gauss_p);
  cell.value = both * scale;
  cell.error = (error_s + error_p) * scale;
  cell.widest_error = largest(error_s) > largest(error_p) ? 0 : 1;
}

double glossy_sum(const ReflectionModel& model, const Vec3<double>& l, const Vec3<double>& v) {
  const Rgb<double> glossy = model.evaluate(l, v).glossy;
  return glossy.r + glossy.g + glossy.b;
}

// Climbs from l to the top of the glossy lobe that l is on, by steps along both angles that are
// halved where none leads up.
Vec3<double> climb(const ReflectionModel& model, const Vec3<double>& v, const Vec3<double>& l) {
  double theta = std::atan2(std::hypot(l.x, l.y), l.z), phi = std::atan2(l.y, l.x);
  double best = glossy_sum(model, l, v);
  for (double step = 0.1; step > 1e-5;) {
    const std::array<double, 2> before{theta, phi};
    for (const auto& [dt, dp] : {std::array{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
      const double value = glossy_sum(model, spherical_direction(theta + dt, phi + dp), v);
      if (value > best) best = value, theta += dt, phi += dp;
    }
    if (before == std::array{theta, phi}) step /= 2;
  }
  return spherical_direction(theta, phi);
}

// The tops reached from the best of directions spread evenly over the hemisphere (a Fibonacci
// lattice). cos^n with n = 1e5 is above 0 in double within 6.8 degrees of its centre, and the
// lattice is denser than that.
std::vector<Vec3<double>> lobe_tops(const ReflectionModel& model, const Vec3<double>& v) {
  constexpr int directions = 2048;
  constexpr std::size_t most = 16;
  constexpr double apart = 0.95;  // cosine; of a broad lobe all of the best are on the same flank
  std::vector<std::pair<double, Vec3<double>>> found;
  for (int i = 0; i < directions; ++i) {
    const double z = (i + 0.5) / directions, phi = i * pi * (3 - std::sqrt(5.0));
    const double sine = std::sqrt(1 - z * z);
    const Vec3<double> l{sine * std::cos(phi), sine * std::sin(phi), z};
    found.emplace_back(glossy_sum(model, l, v), l);
  }
  std::ranges::sort(found, std::greater{}, [](const auto& f) { return f.first; });
  std::vector<Vec3<double>> starts, tops;
  const auto is_new = [](const auto& known, const Vec3<double>& l, double cosine) {
    return std::ranges::all_of(known, [&](const auto& other) { return dot(l, other) < cosine; });
  };
  for (const auto& [value, l] : found)
    if (value > 0 && starts.size() < most && is_new(starts, l, apart)) starts.push_back(l);
  for (const Vec3<double>& start : starts)
    if (const Vec3<double> top = climb(model, v, start); top.z > 0 && is_new(tops, top, 1 - 1e-7))
      tops.push_back(top);
  return tops;
}

// No lobe is narrower than what 15 points resolve in a cell of this width, rad.
constexpr double narrowest_rad = 1.0 / 1024;

// Halves a cell's longer side as long as a top is nearer to it than that side is long: whatever the
// width of a lobe, the cells at its top are as small.
void split_towards(const std::vector<std::array<double, 2>>& tops, const Cell& cell,
                   std::vector<Cell>& cells) {
  const double width_rad[2] = {cell.high[0] - cell.low[0],
                               (cell.high[1] - cell.low[1]) * cell.high[0]};
  const int axis = width_rad[1] > width_rad[0] ? 1 : 0;
  const auto distance = [&](const std::array<double, 2>& top, int i) {
    return std::max({0.0, cell.low[i] - top[i], top[i] - cell.high[i]});
  };
  const bool near = std::ranges::any_of(tops, [&](const auto& top) {
    return std::hypot(distance(top, 0), distance(top, 1) * top[0]) < width_rad[axis];
  });
  if (!near || width_rad[axis] < narrowest_rad) return cells.push_back(cell);
  Cell a = cell, b = cell;
  a.high[axis] = b.low[axis] = 0.5 * (cell.low[axis] + cell.high[axis]);
  split_towards(tops, a, cells);
  split_towards(tops, b, cells);
}

// Points that close in on `centre` from both sides by halves.
void close_in(std::vector<double>& splits, double centre, double reach) {
  splits.push_back(centre);
  for (double distance = reach; distance > narrowest_rad; distance /= 2)
    splits.insert(splits.end(), {centre - distance, centre + distance});
}

// The rectangle, cut so that nothing can hide between the points of a rule: ever thinner towards
// the normal, where most lobes are; where there is a brushing direction, ever thinner towards the
// tangent's and the bitangent's azimuth, along which an anisotropic lobe is long; and towards tops.
std::vector<Cell> first_cells(const ReflectionModel& model, const Vec3<double>& v,
                              const HalfVectors& domain) {
  std::vector<double> s_splits{0}, p_splits;
  for (double s = 1; s > narrowest_rad; s /= 2) s_splits.push_back(s);
  for (int quarter = 0; quarter < 8; ++quarter) p_splits.push_back(-pi + quarter * pi / 4);
  if (model.needs().frame)
    for (int quarter = 0; quarter < 4; ++quarter)
      close_in(p_splits, quarter * pi / 2 - domain.azimuth(), pi / 4);
  for (double& p : p_splits) p = std::remainder(p, 2 * pi);
  p_splits.insert(p_splits.end(), {-pi, pi});
  std::ranges::sort(s_splits), std::ranges::sort(p_splits);

  std::vector<std::array<double, 2>> tops;
  for (const Vec3<double>& top : lobe_tops(model, v))
    if (const auto at = domain.of(top); at[0] > narrowest_rad) tops.push_back(at);
  std::vector<Cell> cells;
  for (std::size_t i = 1; i < s_splits.size(); ++i)
    for (std::size_t j = 1; j < p_splits.size(); ++j)
      if (p_splits[j] > p_splits[j - 1])
        split_towards(
            tops, {{s_splits[i - 1], p_splits[j - 1]}, {s_splits[i], p_splits[j]}, {}, {}}, cells);
  return cells;
}

bool within(const Rgb<double>& error, double tolerance) { return largest(error) <= tolerance; }

}  // namespace

Albedo directional_albedo(const ReflectionModel& model, const Vec3<double>& v, double tolerance,
                          std::int64_t max_evaluations) {
  Albedo albedo;
  if (!(v.z > 0)) return albedo;
  const HalfVectors domain(v);
  std::vector<Cell> cells = first_cells(model, v, domain);
  const auto evaluate = [&](Cell& cell) {
    integrate(model, v, domain, cell);
    albedo.evaluations += points * points;
  };
  Rgb<double> error;
  for (Cell& cell : cells) {
    evaluate(cell);
    error = error + cell.error;
  }
  // A heap, the cell of the largest error on top. `error` is kept up to date by differences, and
  // what rounding makes of it does not matter here: the sum that is returned is taken anew.
  std::make_heap(cells.begin(), cells.end());
  while (!within(error, 0.9 * tolerance) && albedo.evaluations < max_evaluations) {
    std::pop_heap(cells.begin(), cells.end());
    Cell &a = cells.back(), b = a;
    error = error - a.error;
    const int axis = a.widest_error;
    a.high[axis] = b.low[axis] = 0.5 * (a.low[axis] + a.high[axis]);
    evaluate(a), evaluate(b);
    error = error + a.error + b.error;
    std::push_heap(cells.begin(), cells.end());
    cells.push_back(b);
    std::push_heap(cells.begin(), cells.end());
  }
  for (const Cell& cell : cells) {
    albedo.value = albedo.value + cell.value;
    albedo.error = albedo.error + cell.error;
  }
  return albedo;
}

}  // namespace scanlit::models
