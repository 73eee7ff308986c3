// What Scanlit is to reach beside llvmpipe, and whether it does.
#pragma once

#include <string>
#include <vector>

#include "comparison.h"

namespace scanlit::bench {

/// Milliseconds from the start of a program that draws S2 to its picture, the least of several.
struct FirstFrames {
  double scanlit_ms = 0;
  double compiling_ms = 0, cached_ms = 0;  // llvmpipe; cached: an earlier run has compiled
};

/// S1 to S8P: the scenes that the means are taken over.
bool counts_for_mean(const SceneResult& result);

struct TargetResult {
  std::string what;
  double wanted = 0;
  bool at_least = true;                // else at most
  double by_median = 0, by_least = 0;  // the same from median and from least times
  std::string worst;                   // of several scenes, the one that this is
  bool met() const { return at_least ? by_median >= wanted : by_median <= wanted; }
};

/// With two threads; those whose scenes were measured.
std::vector<TargetResult> targets(const std::vector<SceneResult>& results,
                                  const FirstFrames& first_frames);

}  // namespace scanlit::bench
