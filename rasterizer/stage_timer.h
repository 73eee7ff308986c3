// How --stats knows where the time goes.
#pragma once

#include <x86intrin.h>

#include "rasterizer/render.h"

namespace scanlit {

/// Adds the time from its construction to its destruction to one stage: in ticks of the processor's
/// clock, which Renderer::render() turns into seconds when the frame is drawn. To ask the system
/// for the time takes as long as to shade 20 pixels, and a stage may be that short.
class StageTimer {
 public:
  StageTimer(FrameStats& stats, Stage stage)
      : ticks_(stats.seconds[std::size_t(stage)]), start_(now()) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() { ticks_ += double(now() - start_); }

  static std::uint64_t now() { return __rdtsc(); }

 private:
  double& ticks_;
  std::uint64_t start_;
};

}  // namespace scanlit
