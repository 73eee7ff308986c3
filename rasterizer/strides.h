// (8) Every how many pixels of a row a triangle is shaded, where RenderSettings::tolerance allows
// for an error: from bounds of how fast its colour changes.
//
// Along a row, a triangle's colour is f(x) = ambient + sum over the lights of a reflection model at
// directions that change with x. These are bounded by cones and speeds over the whole triangle
// (bounded_directions.h); the model's own formula says what follows for its value, slope, curvature
// and kinks (bounded.h), and so how far at most a straight line between two shaded pixels misses f.
// The misses of all lights and of both parts add up, against the one budget that a pixel has.
//
// What is shown is a code, the encoded colour times 255. Encoding (linear or sRGB) is concave: an
// error of a colour that is at least c changes the code by at most the slope at c. Interpolated
// colours lie between shaded ones, so c is the least colour of the triangle. And a pixel whose
// samples see several triangles mixes their colours in linear light: with T(c) the colour that is E
// codes above c, T is concave, hence a mixture of errors within E codes is within E codes itself.
//
// Assumed is that Batch evaluates f to within `rounding_codes` of a code, of all three pixels
// together: the tests hold every model to less. The same budget pays for codes that are only
// near_codes right (pixel_codes.h), of all pixels, interpolated or not.
//
// Bounds are dear: those of a vector of triangles under one light take about as long as lighting 40
// vectors of pixels. So a few triangles of each chunk are tried, and where little is spared nothing
// else is bounded. The frame alone decides that, not who draws which tile. What a tile holds of a
// large triangle is bounded in tall cells, then those in parts that may spare more than that.
//
// How many times faster frames are with E = 1, how many times they would be were shading free
// (tests/bench/run tolerance; AVX-512, one thread), and which share of the pixels is lit:
//
//        ratio  free  lit        ratio  free  lit        ratio  free  lit        ratio  free  lit
//   R5    4.3    22   .14   R8    1.46  3.3   .50   R2    1.15  1.7   .83   R7    1.06  2.6  1.00
//   R6    2.3    22   .32   R4    1.14  8.2   .85   S3    1.07  2.5   .39   R3    1.05  6.1  1.00
//   R0    2.0   3.2   .19   R1    1.15  1.6  1.00   S5F   1.05  1.2   .18   S8P   1.01  1.1  1.00
//   S6    1.9   7.4   .34                           R9    1.08  1.5  1.00   S2    1.00  1.9   .31
//
// What is missing is a cheap proof for triangles of a few pixels (R2, R4, R7, R9, S8P), and a sharp
// one where many lobes overlap (R3). Tried without gain: 32 pixels of a row and rows below,
// whatever their triangles, with the bends of N, V and P measured pixel by pixel; rectangles of
// large triangles lit on a lattice; cells as narrow as the longest stride; small triangles lit at
// their corners alone, some of them in one cone of directions: of R7's 3 % can be shown to be as
// good by 50 of them, 8 % by 16, and 56 % by 4, whose bounds take longer than their pixels.
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

constexpr int max_stride = 16;

/// Whether codes need only be near (pixel_codes.h).
bool may_be_near(const Frame& frame);

/// Whether an object's fragments may be shaded so at all: per fragment, in colours alone.
bool may_stride(const Frame& frame, const Draw& draw);

/// 1 (every pixel), 2, 4, 8 or 16 in each cell of what a tile holds of a large triangle.
struct CellStrides {
  static constexpr int cells_high = 4;
  int x_begin = 0, y_begin = 0, width = 1, height = 1;  // of the first cell; of each, in pixels
  std::uint8_t stride[cells_high][max_lanes] = {};

  const std::uint8_t* in_row(int y) const { return stride[(y - y_begin) / height]; }
};
CellStrides strides_in(const Frame& frame, const DrawnTriangle& drawn, const Rect& tile);

/// Decides, in all threads of the arena, which draws may be shaded so: those of which half is worth
/// it, by the bounds of some triangles of each chunk.
void try_all_strides(Frame& frame);
/// In all of the triangle: 1, 2, 4, 8 or 16, or `by_cells`, if it is large. Found when a triangle
/// of the chunk is first asked for, for a whole vector of them, and kept for the frame.
int stride_of(const Frame& frame, const DrawnTriangle& drawn);
constexpr int by_cells = 255;

}  // namespace scanlit
