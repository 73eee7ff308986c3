// One moment of scan conversion on a magnified grid.
#pragma once

#include "lessons/studio/watch/moments.h"

namespace scanlit::studio {

/// In pixels. `cell` is the side of a magnified one.
struct ScanPictureSize {
  int width, height;
};
ScanPictureSize scan_picture_size(const Rect& part, int cell);

Framebuffer scan_picture(const ScanStory& story, const Moment& moment, int cell);

}  // namespace scanlit::studio
