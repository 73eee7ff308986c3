// The comparison's scenes, their visible surfaces found by ray tracing: Intel's Embree 3.
//
// Everything in its favour that a caller may do: all triangles in world space, the tree built in
// the best quality beforehand, one ray through each pixel centre of the rectangle that the objects
// fill, in packets of 4 x 4 (4 x 2 where vectors are narrower) declared coherent, over tiles that
// threads take as they come.
#pragma once

#include <string>

#include "bench_scenes.h"
#include "visibility_difference.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace scanlit::bench {

class EmbreePeer {
 public:
  explicit EmbreePeer(int threads);
  EmbreePeer(const EmbreePeer&) = delete;
  EmbreePeer& operator=(const EmbreePeer&) = delete;
  ~EmbreePeer();

  /// Builds frame 0.
  void prepare(const BenchScene& scene);
  /// Traces the pixels of `rect`; returns the milliseconds that threads spent in tiles, summed.
  double trace(const Rect& rect, Hits& hits) const;

  /// "Embree 3.13.5, 16 rays a packet, isa=..."
  std::string version() const;

 private:
  void trace_tile(const Rect& tile, Hits& hits) const;

  int threads_;
  RTCDeviceTy* device_;
  RTCSceneTy* scene_ = nullptr;
  glm::dvec3 eye_{0};
};

}  // namespace scanlit::bench
