// (10) A tile's colours: made in the cache, and brought to memory once, when all are there.
#pragma once

#include <span>
#include <vector>

#include "rasterizer/pipeline.h"
#include "rasterizer/pixel_codes.h"

namespace scanlit {

/// Puts the background behind pixels that are covered in part or not at all.
void put_behind(std::span<float> rgba, const Rgb<double>& background);

/// Kept from tile to tile for its memory.
class TileColours {
 public:
  /// Where the fragments of a tile go, all of them in `touched`. With one sample a pixel they
  /// replace the background, which stands there; else they add up.
  ColourTarget begin(const Frame& frame, const Rect& tile, const Rect& touched, Framebuffer& f);

  /// All fragments are there: fills the tile's part of the framebuffer's colours.
  void finish();

 private:
  std::size_t pixel_size() const { return floats_ ? 4 * sizeof(float) : 4; }
  void make_background();
  /// The pixels of a row of the target, from the first touched one on.
  float* linear_row(int y) const {
    return target_.linear + target_.element(packed_pixel(touched_.x_begin, y));
  }
  std::uint8_t* code_row(int y) const {
    return target_.codes + target_.element(packed_pixel(touched_.x_begin, y));
  }
  void finish_touched(int y);
  /// Pixels of row y of the framebuffer.
  void write(const std::uint8_t* from, int y, int x_begin, int x_end);
  std::uint8_t* in_framebuffer(int x, int y) const;

  const Frame* frame_ = nullptr;
  Framebuffer* f_ = nullptr;
  bool floats_ = false;  // the framebuffer's colours are
  Rect tile_{}, touched_{};
  ColourTarget target_;
  AlignedVector<std::uint8_t> background_;  // a row of the tile, as the framebuffer stores it
  AlignedVector<std::uint8_t> codes_;
  std::vector<float> sums_;
};

}  // namespace scanlit
