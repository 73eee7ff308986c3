// Looking on while a frame is drawn, for what shows how a picture comes about.
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

/// What RenderSettings::probe is told.
class FrameProbe {
 public:
  virtual ~FrameProbe() = default;

  /// A tile has been drawn. Called from any thread, for several tiles at a time; nothing that it is
  /// given outlives the call. With RenderSettings::reuse, only for tiles that are drawn again.
  virtual void tile_drawn(const Frame& frame, const VisibilityTile& visibility) = 0;
};

}  // namespace scanlit
