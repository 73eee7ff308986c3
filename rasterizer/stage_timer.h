// How --stats knows where the time goes.
#pragma once

#include <chrono>

#include "rasterizer/render.h"

namespace scanlit {

/// Adds the time from its construction to its destruction to one stage.
class StageTimer {
 public:
  StageTimer(FrameStats& stats, Stage stage)
      : seconds_(stats.seconds[std::size_t(stage)]), start_(std::chrono::steady_clock::now()) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace scanlit
