#include "lessons/assignments/A8_less_work/reference.h"

#include <algorithm>
#include <cmath>

#include "lessons/assignments/judge/dice.h"

namespace scanlit::assignments::less_work {

using namespace a8;

namespace {

Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}

/// The share with which a light is seen; 0 where it stands behind the surface.
double share(const Variant& variant, const Fragment& fragment, const Light& light) {
  const Vector to_light = minus(light.position, fragment.position);
  if (dot(fragment.normal, to_light) <= 0) return 0;
  const double near = std::sqrt(dot(to_light, to_light)) / light.reach;
  return std::pow(std::max(0., 1 - std::pow(near, variant.inner)), variant.outer);
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
  inner = dice.between(1, 4), outer = dice.between(1, 3);
}

JudgedRow drawn_row(const Variant& variant, std::uint64_t seed) {
  Dice dice(seed, "A8 row");
  JudgedRow row;
  row.width = 64, row.tolerance = 1. / 128;
  row.kd = dice.real(.4, .7), row.ks = dice.real(.2, .5), row.exponent = dice.real(4, 20);
  row.peak = row.kd + row.ks;
  row.colour = {.9, dice.real(.5, .8), dice.real(.2, .6)};
  for (int i = 0; i < 7; ++i) add_surface(dice, variant, row);
  for (int i = 0; i < 48; ++i)
    row.lights.push_back({{dice.real(-20, 84), dice.real(-30, 30), dice.real(-10, 60)},
                          std::exp2(dice.real(-7, -2)),
                          dice.real(25, 70)});
  return row;
}

Colour added(const Variant& variant, const JudgedRow& row, const Pair& pair) {
  const Fragment& f = row.fragments[std::size_t(pair.fragment)];
  const Light& light = row.lights[std::size_t(pair.light)];
  const Vector l = unit(minus(light.position, f.position));
  const double arrives = light.intensity * share(variant, f, light);
  const double n_h = dot(f.normal, unit({l.x, l.y, l.z + 1}));
  const double d = row.kd * std::max(0., dot(f.normal, l)),
               g = row.ks * std::pow(std::max(0., n_h), row.exponent);
  const Colour& c = row.colour;
  return {arrives * (c.r * d + g), arrives * (c.g * d + g), arrives * (c.b * d + g)};
}

std::vector<int> visible(const Variant& variant, const JudgedRow& row) {
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

namespace {

std::vector<Colour> lit(const Variant& variant, const JudgedRow& row,
                        const std::vector<int>& shown) {
  std::vector<Colour> pixels;
  for (const int i : shown) {
    Colour& sum = pixels.emplace_back(Colour{0, 0, 0});
    for (int light = 0; i >= 0 && light < int(row.lights.size()); ++light) {
      const Colour c = added(variant, row, {i, light});
      sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
    }
  }
  return pixels;
}

}  // namespace

std::vector<Colour> right_pixels(const Variant& variant, const JudgedRow& row) {
  return lit(variant, row, visible(variant, row));
}

std::vector<Colour> painted_pixels(const Variant& variant, const JudgedRow& row) {
  std::vector<int> last(std::size_t(row.width), -1);
  for (int i = 0; i < int(row.fragments.size()); ++i)
    last[std::size_t(row.fragments[std::size_t(i)].column)] = i;
  return lit(variant, row, last);
}

Work work(const Variant& variant, const JudgedRow& row) {
  Work sum;
  for (const int i : visible(variant, row)) {
    if (i < 0) continue;
    std::vector<double> bounds;
    for (const Light& light : row.lights)
      bounds.push_back(row.peak * light.intensity *
                       share(variant, row.fragments[std::size_t(i)], light));
    std::ranges::sort(bounds);
    double left_out = 0;
    sum.visible += int(bounds.size());
    for (const double bound : bounds)
      sum.lit += bound > 0, sum.bounded += (left_out += bound) > row.tolerance;
  }
  return sum;
}

}  // namespace scanlit::assignments::less_work
