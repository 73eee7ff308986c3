#include "versus_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "report.h"

namespace scanlit::bench {

namespace {

const std::vector<std::string>& stage_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (int s = 0; s < int(Stage::count); ++s) all.emplace_back(name(Stage(s)));
    all.push_back("other");
    return all;
  }();
  return names;
}

std::string ratio_text(const SceneResult& result) {
  char text[32] = "differs";
  if (result.same)
    std::snprintf(text, sizeof text, "%7.2f %6.2f %6.2f", result.ratio(), result.min_ratio(),
                  result.cpu_ratio());
  return text;
}

/// Geometric mean, and least, of S1 to S8P.
void print_mean(const char* what, const std::vector<SceneResult>& results,
                double (SceneResult::*ratio)() const) {
  double log_sum = 0, least = std::numeric_limits<double>::infinity();
  int count = 0;
  for (const SceneResult& result : results) {
    if (!counts_for_mean(result) || !result.same) continue;
    log_sum += std::log((result.*ratio)());
    least = std::min(least, (result.*ratio)());
    ++count;
  }
  if (count > 0)
    std::printf("      ratio of %s over %d scenes: geometric mean %.2f, least %.2f\n", what, count,
                std::exp(log_sum / count), least);
}

}  // namespace

void print_header() {
  std::printf(
      "ms per frame, %dx%d, on %s, Scanlit's vectors: %s; median (least, processor time)\n"
      "%-5s %-7s %-22s %-25s %-25s %7s %6s %6s  %-9s %s\n",
      picture_width, picture_height, machine().c_str(), vector_level().c_str(), "scene", "threads",
      "Scanlit", "llvmpipe to a buffer", "llvmpipe, glReadPixels", "ratio", "least", "by cpu",
      "max, mean", "covered pixels");
}

void print_row(const SceneResult& result) {
  const auto time = [](const FrameTime& t, int width) {
    char text[80];
    std::snprintf(text, sizeof text, "%.2f (%.2f, %.2f)", t.median_ms, t.min_ms, t.cpu_ms);
    std::printf("%-*s ", width, text);
  };
  std::printf("%-5s %-7d ", result.scene.c_str(), result.threads);
  time(result.scanlit, 22);
  time(result.buffer, 25);
  time(result.framebuffer_object, 25);
  std::printf("%-21s  %2.0f, %.3f %8lld %lld\n", ratio_text(result).c_str(), result.max_difference,
              result.mean_difference, static_cast<long long>(result.covered[0]),
              static_cast<long long>(result.covered[1]));
  if (!result.same) std::printf("      pictures differ: %s\n", result.difference.c_str());
  if (result.yardstick && result.scene == "S0")
    std::printf("      one memset of the colour buffer: %.2f (%.2f)\n", result.yardstick->median_ms,
                result.yardstick->min_ms);
  else if (result.yardstick)
    std::printf("      Scanlit without reuse: %.2f (%.2f), %.2f times as long\n",
                result.yardstick->median_ms, result.yardstick->min_ms,
                result.yardstick->median_ms / result.scanlit.median_ms);
  std::fflush(stdout);
}

void print_summary(const std::vector<SceneResult>& results) {
  print_mean("medians", results, &SceneResult::ratio);
  print_mean("least times", results, &SceneResult::min_ratio);
  print_mean("processor times", results, &SceneResult::cpu_ratio);
  if (!results.empty()) std::printf("      %s\n", results.front().peer.c_str());
}

void print_stages(const std::vector<SceneResult>& results) {
  std::printf("\nScanlit's stages, ms per frame summed over the threads\n%-5s %-7s", "scene",
              "threads");
  for (const std::string& stage : stage_names()) std::printf("%16s", stage.c_str());
  std::printf("\n");
  for (const SceneResult& result : results) {
    std::printf("%-5s %-7d", result.scene.c_str(), result.threads);
    for (const std::string& stage : stage_names()) std::printf("%16.3f", result.stages.at(stage));
    std::printf("\n");
  }
}

void print_targets(const std::vector<TargetResult>& results) {
  std::printf("\n%-32s %8s %9s %9s\n", "targets, two threads", "wanted", "medians", "least");
  for (const TargetResult& target : results)
    std::printf("%-32s %s %5.1f %9.2f %9.2f  %s%s\n", target.what.c_str(),
                target.at_least ? ">=" : "<=", target.wanted, target.by_median, target.by_least,
                target.met() ? "met" : "not met",
                target.worst.empty() ? "" : (", worst " + target.worst).c_str());
}

}  // namespace scanlit::bench
