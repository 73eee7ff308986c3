#include "lessons/assignments/A8_less_work/reference.h"

#include <algorithm>
#include <cmath>

#include "lessons/assignments/judge/dice.h"

namespace scanlit::assignments::less_work {

using namespace a8;

namespace {

constexpr double kd = .6, ks = .4;  // their sum is Row::peak
constexpr double exponent = 12;

Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}

/// The share with which a light is seen; 0 where it stands behind the surface.
double share(const Fragment& fragment, const Light& light) {
  const Vector to_light = minus(light.position, fragment.position);
  if (dot(fragment.normal, to_light) <= 0) return 0;
  const double s = std::max(0., 1 - dot(to_light, to_light) / (light.reach * light.reach));
  return s * s;
}

/// A cylinder seen from the side, at a distance along z.
void add_surface(Dice& dice, const Variant& variant, Row& row) {
  const double middle = dice.real(6, row.width - 6), radius = dice.real(8, 24);
  const double z = dice.real(-10, 10);
  for (int column = 0; column < row.width; ++column) {
    const double across = (column + .5 - middle) / radius;
    if (std::abs(across) >= 1) continue;
    const double up = std::sqrt(1 - across * across);
    const Vector position{column + .5, 0, z + radius * up};
    // Depths are rounded, so that some are equal.
    const double near = std::round(position.z * 4) / 4;
    row.fragments.push_back(
        {column, variant.larger_is_nearer ? near : -near, position, {across, 0, up}});
  }
}

}  // namespace

Variant::Variant(std::uint64_t seed) {
  Dice dice(seed, "A8");
  larger_is_nearer = dice.coin(), first_wins = dice.coin();
}

Row drawn_row(const Variant& variant, std::uint64_t seed) {
  Dice dice(seed, "A8 row");
  Row row{.width = 64, .fragments = {}, .lights = {}, .peak = kd + ks, .tolerance = 1. / 128};
  for (int i = 0; i < 7; ++i) add_surface(dice, variant, row);
  for (int i = 0; i < 48; ++i)
    row.lights.push_back({{dice.real(-20, 84), dice.real(-30, 30), dice.real(-10, 60)},
                          std::exp2(dice.real(-7, -2)),
                          dice.real(25, 70)});
  return row;
}

Colour added(const Row& row, const Pair& pair) {
  const Fragment& f = row.fragments[std::size_t(pair.fragment)];
  const Light& light = row.lights[std::size_t(pair.light)];
  const Vector l = unit(minus(light.position, f.position));
  const double arrives = light.intensity * share(f, light);
  const double n_h = dot(f.normal, unit({l.x, l.y, l.z + 1}));
  const double d = kd * std::max(0., dot(f.normal, l)),
               g = ks * std::pow(std::max(0., n_h), exponent);
  return {arrives * (.9 * d + g), arrives * (.7 * d + g), arrives * (.4 * d + g)};
}

std::vector<int> visible(const Variant& variant, const Row& row) {
  std::vector<int> seen(std::size_t(row.width), -1);
  for (int i = 0; i < int(row.fragments.size()); ++i) {
    const Fragment& f = row.fragments[std::size_t(i)];
    int& at = seen[std::size_t(f.column)];
    const double other = at < 0 ? 0 : row.fragments[std::size_t(at)].depth;
    const bool nearer = variant.larger_is_nearer ? f.depth > other : f.depth < other;
    if (at < 0 || nearer || (f.depth == other && !variant.first_wins)) at = i;
  }
  return seen;
}

std::vector<Colour> right_pixels(const Variant& variant, const Row& row) {
  std::vector<Colour> pixels;
  for (const int i : visible(variant, row)) {
    Colour& sum = pixels.emplace_back(Colour{0, 0, 0});
    for (int light = 0; i >= 0 && light < int(row.lights.size()); ++light) {
      const Colour c = added(row, {i, light});
      sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
    }
  }
  return pixels;
}

Work work(const Variant& variant, const Row& row) {
  Work sum;
  for (const int i : visible(variant, row)) {
    if (i < 0) continue;
    std::vector<double> bounds;
    for (const Light& light : row.lights)
      bounds.push_back(light.intensity * share(row.fragments[std::size_t(i)], light) * row.peak);
    std::ranges::sort(bounds);
    double left_out = 0;
    sum.visible += int(bounds.size());
    for (const double bound : bounds)
      sum.lit += bound > 0, sum.bounded += (left_out += bound) > row.tolerance;
  }
  return sum;
}

}  // namespace scanlit::assignments::less_work
