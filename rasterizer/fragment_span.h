// (8), (9) Visible fragments, gathered: what resolve hands to shading.
#pragma once

#include <vector>

#include "rasterizer/pipeline.h"

namespace scanlit {

/// Consecutive fragments of one triangle in a span.
struct Run {
  const DrawnTriangle* drawn;
  std::uint16_t first, size;  // in the span
  // strides.h: fragments are every so many pixels, and at the last of so many; the colours of those
  // between are interpolated.
  std::uint8_t stride;
  std::uint16_t pixels;
};

/// A pixel as one number; in a row they are consecutive. Sides are at most 2^14.
inline std::uint32_t packed_pixel(int x, int y) {
  return std::uint32_t(y) << 16 | std::uint32_t(x);
}
/// Its place in a picture.
inline std::size_t index_of_pixel(std::uint32_t packed, std::size_t width) {
  return std::size_t(packed >> 16) * width + (packed & 0xffff);
}

/// Visible fragments of one object, gathered across triangles, gaps and rows, so that vectors are
/// full also where triangles are as small as pixels. An attribute a of a run's triangle is
/// a0 + b1 (a1 - a0) + b2 (a2 - a0).
struct FragmentSpan {
  static constexpr int capacity = 512;
  static constexpr int padded = capacity + int(max_lanes);
  using PerRun = float[padded];  // one number for each run
  // So that each array begins at a line of the cache (aligned_vector.h) if the one before it does.
  static_assert(sizeof(PerRun) % cache_line == 0);

  const Draw* draw = nullptr;
  int size = 0, run_count = 0;
  int pixels = 0;           // of all runs
  bool may_stride = false;  // strides.h
  // Of each run its triangle's number in the tile, and past its last fragment; the rest is made of
  // them when the span is full.
  alignas(cache_line) TriangleId triangle[padded];
  std::uint32_t end[padded];
  Run runs[capacity];
  PerRun facing;                 // 1, or -1 where its normal is flipped to the viewer's side
  std::int32_t run[padded];      // of each fragment: the number of its run
  std::uint32_t pixel[padded];   // packed_pixel(); row by row, from left to right
  float weight[padded];          // share of the pixel's samples, 0..1
  float b1[padded], b2[padded];  // barycentric coordinates in the mesh's triangle, where needed

  std::uint32_t first_pixel[padded];  // of each run

  /// Of each run what it is shaded by, over w (planes.h): in the run's row at a column of its
  /// triangle's, and by how much it grows from there to the next.
  struct Planes {
    alignas(cache_line) PerRun column, start[4], per_column[4];
  } planes;
  // Runs whose triangles were cut or whose planes are not precise, and those of centroids: they are
  // shaded by b1 and b2, which they have wherever anything varies over a triangle.
  std::vector<int> exact;

  // Runs of one fragment each that is not at its pixel's centre, and where it is, in 1/256 pixel.
  struct Centroid {
    int run;
    double x, y;
  };
  std::vector<Centroid> centroids;

  /// Runs that are not shaded at every pixel.
  struct Strided {
    int run, stride, pixels;
  };
  std::vector<Strided> strided;

  void clear() {
    size = run_count = pixels = 0;
    exact.clear(), centroids.clear(), strided.clear();
  }

  // By how much b1 and b2 grow to the next pixel, to first order; only `with_derivatives`.
  bool with_derivatives = false;
  struct Derivatives {
    alignas(cache_line) float b1[padded], b2[padded];
  } dx, dy;  // on the right, below
};

}  // namespace scanlit
