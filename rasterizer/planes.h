// (8), (9) Attributes as planes over the screen. Over w they are linear there, and so is 1/w: what
// is the same for all rows of a triangle is made once, and a fragment costs one multiplication a
// channel.
#pragma once

#include <vector>

#include "rasterizer/of_runs.h"

namespace scanlit {

/// Of the triangles that a tile's spans have met lately, the attribute that fragments are shaded
/// by: Gouraud's colour, or else the normal, on the viewer's side. A fragment's depends on its
/// triangle and its pixel alone, to the bit.
class TrianglePlanes {
 public:
  /// Other triangles follow: those below this number.
  void begin(std::size_t triangles);

  /// Fills planes, facing and exact of a span whose runs and pixels are there.
  void put(const Frame& frame, const VisibilityTile& visibility, FragmentSpan& span);

 private:
  static constexpr int capacity = 2 * FragmentSpan::capacity;  // more would leave the cache
  struct Quad {
    float v[4];
  };

  int number(const FragmentSpan& span);
  void copy_corners(const Frame& frame, const VisibilityTile& visibility, const FragmentSpan& span,
                    int count);
  void make(const Frame& frame, const FragmentSpan& span, int count, int first);
  void put_rows(FragmentSpan& span);

  // Triangles are numbered as they come, on and on; those from base_ on have planes.
  std::vector<std::int32_t> number_;  // of each of the tile's, where it has one
  int base_ = 0, next_ = 0;
  // Four channels, the fourth 1/w, at an origin, and their growth per column and per row; and of
  // the origin column, row, facing, and 1 where float is not precise.
  alignas(cache_line) Quad at_origin_[capacity + max_lanes], per_column_[capacity + max_lanes],
      per_row_[capacity + max_lanes], origin_[capacity + max_lanes];

  // Of those whose planes are to be made.
  alignas(cache_line) TriangleId new_[FragmentSpan::padded];
  ScreenVertex vertices_[3][FragmentSpan::padded];
  Quad values_[3][FragmentSpan::padded];
  float cut_[FragmentSpan::padded];

  std::int32_t place_[FragmentSpan::padded]{};  // of each run's triangle, where the planes are
};

/// A span's planes at a vector of fragments, from fragment i on.
class OnPlanes {
 public:
  OnPlanes(const FragmentSpan& span, int i)
      : planes_(span.planes), of_(span.run + i), steps_(columns(span, i) - of_(planes_.column)) {}

  /// Channel c over w; 3 is 1/w. All times a number that is the triangle's own.
  Batch operator()(int c) const {
    return mul_add(steps_, of_(planes_.per_column[c]), of_(planes_.start[c]));
  }

 private:
  const FragmentSpan::Planes& planes_;
  OfRuns of_;
  Batch steps_;
};

}  // namespace scanlit
