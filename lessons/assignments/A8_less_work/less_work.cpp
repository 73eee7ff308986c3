// A8, less work. README.md says what shade() is to do; `scanlit check .` says how far you are.
#include "less_work.h"

#include <algorithm>
#include <cmath>

#include "variant.h"

namespace a8 {

//<<
namespace {

Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Whether a fragment hides one that was drawn before it.
bool hides(const Fragment& later, const Fragment& earlier) {
  if (later.depth == earlier.depth) return !variant::first_wins;
  return (later.depth > earlier.depth) == variant::larger_is_nearer;
}

/// The index of the fragment that each pixel shows; -1 where there is none.
std::vector<int> visible(const Row& row) {
  std::vector<int> seen(std::size_t(row.width), -1);
  for (int i = 0; i < int(row.fragments.size()); ++i) {
    int& at = seen[std::size_t(row.fragments[std::size_t(i)].column)];
    if (at < 0 || hides(row.fragments[std::size_t(i)], row.fragments[std::size_t(at)])) at = i;
  }
  return seen;
}

/// The most that a light can add.
double bound(const Row& row, const Fragment& fragment, const Light& light) {
  const Vector to_light = light.position - fragment.position;
  if (dot(fragment.normal, to_light) <= 0) return 0;
  const double share = std::max(0.0, 1 - dot(to_light, to_light) / (light.reach * light.reach));
  return light.intensity * share * share * row.peak;
}

}  // namespace

//>>
std::vector<Colour> shade(const Row& row) {
  //<< TODO(A8) The picture first, then the same with fewer evaluations.
  std::vector<Pair> pairs;
  for (const int i : visible(row)) {
    if (i < 0) continue;
    std::vector<std::pair<double, int>> lights;
    for (int light = 0; light < int(row.lights.size()); ++light)
      lights.emplace_back(bound(row, row.fragments[std::size_t(i)], row.lights[std::size_t(light)]),
                          light);
    // The weakest are left out, as long as all of them together cannot be seen.
    std::ranges::sort(lights);
    double left_out = 0;
    for (const auto& [most, light] : lights)
      if ((left_out += most) > row.tolerance) pairs.push_back({i, light});
  }
  const std::vector<Colour> added = evaluate(pairs);
  std::vector<Colour> pixels(std::size_t(row.width), Colour{0, 0, 0});
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    Colour& pixel = pixels[std::size_t(row.fragments[std::size_t(pairs[k].fragment)].column)];
    pixel = {pixel.r + added[k].r, pixel.g + added[k].g, pixel.b + added[k].b};
  }
  return pixels;
  //== return std::vector<Colour>(std::size_t(row.width), Colour{0.5, 0.5, 0.5});
  //>>
}

}  // namespace a8
