// (8) The edge functions of a span's runs: barycentric coordinates of most triangles.
#pragma once

#include "rasterizer/of_runs.h"

namespace scanlit {

struct CornerVectors;

/// Of each run the edge functions opposite to its triangle's corners, exact at a pixel of its row,
/// and their growth per pixel; and the corners' 1/w. Made for vectors of runs, for vectors of
/// fragments to pick from. A fragment's depend on its triangle and its pixel alone, to the bit.
class EdgeFunctions {
 public:
  EdgeFunctions(const Frame& frame, const FragmentSpan& span);

  /// At a vector of fragments in these columns, over w.
  Batch at(const OfRuns& of, int corner, const Batch& column) const {
    const Batch pixels = column - of(column_);
    return mul_add(pixels, of(per_pixel_[corner]), of(first_[corner])) * of(inv_w_[corner]);
  }

 private:
  void put_functions(const CornerVectors& corners, int r, const FragmentSpan& span);

  alignas(cache_line) ScreenVertex vertices_[3][FragmentSpan::padded];  // of each run's triangle
  FragmentSpan::PerRun column_;                                         // of that pixel
  FragmentSpan::PerRun first_[3], per_pixel_[3], inv_w_[3];
};

}  // namespace scanlit
