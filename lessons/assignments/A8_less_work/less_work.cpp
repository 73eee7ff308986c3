// A8, less work. README.md says what shade() is to do; `scanlit check .` says how far you are.
#include "less_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace

//>>
/// Of each pixel the fragment that is seen, an index; -1 where there is none.
std::vector<int> visible(const Row& row) {
  std::vector<int> seen(std::size_t(row.width), -1);
  for (int i = 0; i < int(row.fragments.size()); ++i) {
    const Fragment& f = row.fragments[std::size_t(i)];
    int& at = seen[std::size_t(f.column)];
    //<< TODO(A8.1) Of two the nearer one; your variant says which that is, and what if none is.
    if (at < 0 || hides(f, row.fragments[std::size_t(at)])) at = i;
    //== at = i;
    //>>
  }
  return seen;
}

/// The most that a light can add to a channel.
double bound(const Row& row, const Fragment& fragment, const Light& light) {
  //<< TODO(A8.3) Nothing from behind the surface or out of reach; else less with distance.
  const Vector to_light = light.position - fragment.position;
  if (dot(fragment.normal, to_light) <= 0) return 0;
  const double near = std::sqrt(dot(to_light, to_light)) / light.reach;
  if (near >= 1) return 0;
  const double share = std::pow(1 - std::pow(near, variant::inner), variant::outer);
  return light.intensity * share * row.peak;
  //== return light.intensity * row.peak;
  //>>
}

/// The lights that are evaluated for a fragment.
std::vector<int> lights_of(const Row& row, const Fragment& fragment) {
  std::vector<std::pair<double, int>> lights;  // the most that it can add, and which
  for (int i = 0; i < int(row.lights.size()); ++i) {
    const double most = bound(row, fragment, row.lights[std::size_t(i)]);
    if (most > 0) lights.emplace_back(most, i);
  }
  //<< TODO(A8.4) Without the weakest, as long as nobody can notice.
  std::ranges::sort(lights);
  auto first = lights.begin();
  for (double left_out = 0; first != lights.end(); ++first)
    if ((left_out += first->first) > row.tolerance) break;
  lights.erase(lights.begin(), first);
  //>>
  std::vector<int> all;
  for (const auto& [most, light] : lights) all.push_back(light);
  return all;
}

std::vector<Colour> shade(const Row& row) {
  const std::vector<int> seen = visible(row);
  std::vector<Pair> pairs;
  //<< TODO(A8.2) Every fragment is evaluated as it was drawn, seen or not.
  for (const int i : seen)
    if (i >= 0)
      for (const int light : lights_of(row, row.fragments[std::size_t(i)]))
        pairs.push_back({i, light});
  //== for (int i = 0; i < int(row.fragments.size()); ++i)
  //==   for (const int light : lights_of(row, row.fragments[std::size_t(i)]))
  //==     pairs.push_back({i, light});
  //>>
  const std::vector<Colour> added = evaluate(pairs);
  std::vector<Colour> pixels(std::size_t(row.width), Colour{0, 0, 0});
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const int column = row.fragments[std::size_t(pairs[k].fragment)].column;
    if (seen[std::size_t(column)] != pairs[k].fragment) continue;
    Colour& pixel = pixels[std::size_t(column)];
    pixel = {pixel.r + added[k].r, pixel.g + added[k].g, pixel.b + added[k].b};
  }
  return pixels;
}

}  // namespace a8
