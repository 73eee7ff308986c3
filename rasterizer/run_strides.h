// (8) The strides of a tile's runs (strides.h), asked once for all rows.
#pragma once

#include <algorithm>
#include <unordered_map>

#include "rasterizer/fragment_span.h"
#include "rasterizer/strides.h"

namespace scanlit {

class RunStrides {
 public:
  RunStrides(const Frame& frame, const VisibilityTile& visibility)
      : frame_(frame), visibility_(visibility) {}

  /// Whether to shade a run every few pixels: its own cost is that of lighting some ten of them.
  bool may_stride(const FragmentSpan& span, TriangleId id, int size) {
    const int lights = int(span.draw->illumination.lights.size());
    return size > 3 && size * lights > 10 && of_triangle(id) > 1;
  }

  /// The stride of a run's pixels up to `until`.
  struct Stretch {
    int stride, until;
  };
  /// From pixel (x, y) on, in a run of this triangle that ends before `end`.
  Stretch at(TriangleId id, int x, int y, int end) {
    const auto stretch_to = [&](int until, int stride) {
      return Stretch{until - x > 3 ? stride : 1, until};
    };
    if (of_triangle(id) != by_cells) return stretch_to(end, of_triangle(id));
    const CellStrides& cells = cells_of(id);
    const std::uint8_t* const strides = cells.in_row(y);
    const int column = (x - cells.x_begin) / cells.width, stride = strides[column];
    int until = column + 1;
    // From within a cell no stride may lead into the next.
    const bool whole = (x - cells.x_begin) % cells.width == 0;
    while (whole && cells.x_begin + until * cells.width < end && strides[until] == stride) ++until;
    return stretch_to(std::min(end, cells.x_begin + until * cells.width), stride);
  }

 private:
  int of_triangle(TriangleId id) {
    if (strides_.empty()) strides_.resize(visibility_.triangles.size());
    std::uint8_t& stride = strides_[id];
    if (stride == 0) stride = std::uint8_t(stride_of(frame_, *visibility_.triangles[id]));
    return stride;
  }

  const CellStrides& cells_of(TriangleId id) {
    const auto [place, is_new] = cells_.try_emplace(id);
    if (is_new) place->second = strides_in(frame_, *visibility_.triangles[id], visibility_.rect);
    return place->second;
  }

  const Frame& frame_;
  const VisibilityTile& visibility_;
  std::vector<std::uint8_t> strides_;  // stride_of() the tile's triangles; 0: not known yet
  std::unordered_map<TriangleId, CellStrides> cells_;
};

}  // namespace scanlit
