#include "versus_targets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "rasterizer/batch.h"

namespace scanlit::bench {

namespace {

using Results = std::vector<SceneResult>;
using Time = double FrameTime::*;

const SceneResult* find(const Results& results, const std::string& scene, int threads) {
  const auto found = std::ranges::find_if(
      results, [&](const SceneResult& r) { return r.scene == scene && r.threads == threads; });
  return found == results.end() ? nullptr : &*found;
}

/// A quotient of two times of one scene, or nothing: not measured, or the pictures differ.
using Quotient = std::function<double(const std::string& scene, Time time)>;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The one of several scenes that is farthest from the target.
void add_worst(std::vector<TargetResult>& all, TargetResult target,
               const std::vector<std::string>& scenes, const Quotient& quotient) {
  const double sign = target.at_least ? 1 : -1;
  bool any = false;
  for (const std::string& scene : scenes) {
    const double by_median = quotient(scene, &FrameTime::median_ms);
    if (std::isnan(by_median) || (any && sign * by_median >= sign * target.by_median)) continue;
    any = true;
    target.by_median = by_median;
    target.by_least = quotient(scene, &FrameTime::min_ms);
    target.worst = scenes.size() > 1 ? scene : "";
  }
  if (any) all.push_back(target);
}

double geometric_mean(const std::vector<std::string>& scenes, const Quotient& quotient, Time time) {
  double sum = 0;
  for (const std::string& scene : scenes) sum += std::log(quotient(scene, time));
  return std::exp(sum / double(scenes.size()));
}

}  // namespace

bool counts_for_mean(const SceneResult& result) {
  static const std::set<std::string> others = {"S0", "S9", "S10L", "S10M", "S10N"};
  return !others.contains(result.scene);
}

std::vector<TargetResult> targets(const Results& results, const FirstFrames& first_frames) {
  const bool widest = Batch::lanes == 16;
  const std::vector<std::string> plain = {"S1",  "S2", "S3", "S4",  "S5F", "S5B",
                                          "S5M", "S6", "S7", "S8G", "S8P"};
  const auto ratio = [&](const std::string& scene, Time time) {
    const SceneResult* const r = find(results, scene, 2);
    return r && r->same ? r->buffer.*time / r->scanlit.*time : nothing;
  };
  const auto over_s5f = [&](const std::string& scene, Time time) {
    const SceneResult *const r = find(results, scene, 2), *const s5f = find(results, "S5F", 2);
    return r && s5f ? r->scanlit.*time / s5f->scanlit.*time : nothing;
  };
  const auto over_memset = [&](const std::string& scene, Time time) {
    const SceneResult* const r = find(results, scene, 2);
    return r ? r->scanlit.*time / (*r->yardstick).*time : nothing;
  };
  const auto scaling = [&](const std::string& scene, Time time) {
    const SceneResult *const one = find(results, scene, 1), *const two = find(results, scene, 2);
    return one && two ? one->scanlit.*time / two->scanlit.*time : nothing;
  };

  std::vector<TargetResult> all;
  add_worst(all, {.what = "each of S1 to S8P", .wanted = widest ? 4 : 2.5, .worst = {}}, plain,
            ratio);
  add_worst(all, {.what = "S5F, S5B, S5M", .wanted = 10, .worst = {}}, {"S5F", "S5B", "S5M"},
            ratio);
  const double by_median = geometric_mean(plain, ratio, &FrameTime::median_ms);
  if (!std::isnan(by_median))
    all.push_back({.what = "geometric mean of S1 to S8P",
                   .wanted = widest ? 7 : 5,
                   .by_median = by_median,
                   .by_least = geometric_mean(plain, ratio, &FrameTime::min_ms),
                   .worst = {}});
  add_worst(all, {.what = "S5B, S5M over S5F", .wanted = 1.3, .at_least = false, .worst = {}},
            {"S5B", "S5M"}, over_s5f);
  add_worst(all, {.what = "S9", .wanted = 10, .worst = {}}, {"S9"}, ratio);
  add_worst(
      all,
      {.what = "S0 over a memset of the colours", .wanted = 1.5, .at_least = false, .worst = {}},
      {"S0"}, over_memset);
  add_worst(all, {.what = "one thread over two, S2 to S6", .wanted = 1.8, .worst = {}},
            {"S2", "S3", "S4", "S5F", "S5B", "S5M", "S6"}, scaling);
  const double sooner = first_frames.compiling_ms / first_frames.scanlit_ms;
  all.push_back({.what = "first frame, S2",
                 .wanted = 5,
                 .by_median = sooner,
                 .by_least = sooner,
                 .worst = {}});
  return all;
}

}  // namespace scanlit::bench
