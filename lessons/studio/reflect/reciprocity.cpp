#include "lessons/studio/reflect/reciprocity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "lessons/studio/reflect/query.h"

namespace scanlit::studio {
namespace {

/// theta and phi of l and of v, rad.
using Angles = std::array<double, 4>;

class Search {
 public:
  explicit Search(const ReflectionModel& model) : model_(model) {}

  Violation at(const Angles& a) const {
    Violation result;
    result.l = models::spherical_direction(a[0], a[1]);
    result.v = models::spherical_direction(a[2], a[3]);
    if (result.l.z < least_cosine || result.v.z < least_cosine) return result;
    const double scale_l = 1 / (std::numbers::pi * result.l.z);
    const double scale_v = 1 / (std::numbers::pi * result.v.z);
    result.forward = reflected(model_, result.l, result.v) * scale_l;
    result.backward = reflected(model_, result.v, result.l) * scale_v;
    for (const auto c : {&Rgb<double>::r, &Rgb<double>::g, &Rgb<double>::b}) {
      const double larger = std::max(result.forward.*c, result.backward.*c);
      if (larger > floor_)
        result.relative =
            std::max(result.relative, std::abs(result.forward.*c - result.backward.*c) / larger);
    }
    return result;
  }

  /// Sets what counts as 0, from the largest value among `pairs`.
  void look_for_floor(const std::vector<Angles>& pairs) {
    double largest = 0;
    for (const Angles& pair : pairs) {
      const Rgb<double> f = at(pair).forward;
      largest = std::max({largest, f.r, f.g, f.b});
    }
    floor_ = 1e-9 * largest;
  }

  /// Steps along each angle, halved where none makes it worse.
  Violation climb(Angles a) const {
    Violation best = at(a);
    for (double step = 0.05; step > 1e-4;) {
      bool worse = false;
      for (std::size_t i = 0; i < a.size(); ++i)
        for (const double by : {step, -step}) {
          Angles b = a;
          b[i] += by;
          if (const Violation there = at(b); there.relative > best.relative)
            best = there, a = b, worse = true;
        }
      if (!worse) step /= 2;
    }
    return best;
  }

 private:
  const ReflectionModel& model_;
  double floor_ = 0;
};

std::vector<Angles> pairs_of_directions(int count) {
  constexpr double pi = std::numbers::pi;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto even = [&] { return std::acos(unit(random)); };
  const auto grazing = [&] { return pi / 2 - std::pow(10, -3 * unit(random)); };
  std::vector<Angles> pairs;
  while (int(pairs.size()) < count) {
    const double a = even(), b = grazing(), phi = 2 * pi * unit(random);
    const double nearness = std::pow(10, -4 * unit(random));
    pairs.push_back({a, phi, even(), 2 * pi * unit(random)});
    pairs.push_back({b, phi, even(), 2 * pi * unit(random)});
    pairs.push_back({b, phi, grazing(), 2 * pi * unit(random)});
    // About the mirror direction, where sharp lobes are.
    pairs.push_back({a, phi, a + nearness * unit(random), phi + pi + nearness * unit(random)});
  }
  return pairs;
}

}  // namespace

Violation worst_violation(const ReflectionModel& model) {
  constexpr std::size_t climbers = 32;
  std::vector<Angles> pairs = pairs_of_directions(20'000);
  Search search(model);
  search.look_for_floor(pairs);
  std::vector<std::pair<double, Angles>> found;
  for (const Angles& pair : pairs) found.emplace_back(search.at(pair).relative, pair);
  std::ranges::partial_sort(found, found.begin() + climbers, std::greater{},
                            [](const auto& f) { return f.first; });
  Violation worst = search.at(found[0].second);
  for (std::size_t i = 0; i < climbers; ++i)
    if (const Violation top = search.climb(found[i].second); top.relative > worst.relative)
      worst = top;
  return worst;
}

}  // namespace scanlit::studio
