// (8) Every how many pixels of a row a triangle is shaded, where RenderSettings::tolerance allows
// for an error: from bounds of how fast its colour changes.
//
// Along a row, a triangle's colour is f(x) = ambient + sum over the lights of a reflection model at
// directions that change with x. strides() bounds the directions by cones and speeds over the whole
// triangle (bounded_directions.h), lets the model's own formula say what follows from it for its
// value, slope and curvature (bounded.h), and so knows how far at most a straight line between two
// shaded pixels h apart misses f. The misses of all lights and of both parts add up, against the
// one budget that a pixel has.
//
// What is shown is a code, the encoded colour times 255. Encoding (linear or sRGB) is concave: an
// error of a colour that is at least c changes the code by at most the slope at c. Interpolated
// colours lie between shaded ones, so c is the least colour of the triangle. And a pixel whose
// samples see several triangles mixes their colours in linear light: with T(c) the colour that is E
// codes above c, T is concave, hence a mixture of errors within E codes is within E codes itself.
//
// Assumed is that Batch evaluates f to within `rounding` of a code at each of the three pixels: the
// tests hold every model to less.
//
// Bounds are dear: those of a vector of triangles under one light take about as long as lighting 80
// vectors of pixels. So a few triangles of each chunk are tried, and where little is spared nothing
// else is bounded. The frame alone decides that, not who draws which tile.
//
// How many times faster frames are with E = 1 than with 0, and would be were shading free
// (tests/bench/run tolerance; AVX-512, one thread):
//
//   S6 1.75 of 24   R5 2.1 of 89   R6 1.4 of 18    R0 1.2 of 11    S2 1.1 of 1.8   R8 1.0 of 2.1
//   R3 .99 of 17    R4 1.0 of 5    S3 1.0 of 2.5   R2 1.0 of 2.3   R7 1.0 of 2.3
//
// and the others 1.0 of 1.1 to 1.5. Where shading is more than half of the frame that is 1.2 in the
// geometric mean, not yet the 1.5 that is wanted. Straight lines could do it: with the best stride
// for each 32 pixels of a row .10 to .21 of these scenes' pixels need be lit (R9 .32, R3 .42). What
// is missing is a cheap proof where triangles are small. Tried and not kept: bounds over 32 pixels
// of a row and several rows below, whatever their triangles, with the bends of N, V and P measured
// pixel by pixel. Then .44 (R5) to .99 (R3) of the pixels are lit, and only R5 and R6 get faster: a
// cone that serves so many pixels holds a lobe or a horizon of some light. Not tried: to bound many
// lights as one, and to leave out lobes whose bound is below their share.
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

constexpr double rounding_codes = 0.1;  // of all three, together
constexpr int max_stride = 16;

/// Whether an object's fragments may be shaded so at all: per fragment, in colours alone.
bool may_stride(const Frame& frame, const Draw& draw);

/// Whether it is better bounded strip by strip.
bool is_large(const DrawnTriangle& drawn);

/// 1 (every pixel), 2, 4, 8 or 16 in some rows of a large triangle, column by column.
struct StripStrides {
  int y_end = 0;                        // rows from there on are not known yet
  int x_begin = 0, width = 1;           // the first column; pixels in a column
  std::uint8_t stride[max_lanes] = {};  // of each column
};
/// From row y of a tile on.
StripStrides strides_in(const Frame& frame, const DrawnTriangle& drawn, const Rect& tile, int y);

/// Bounds some of a chunk's triangles, and by them decides whether the others are worth it, which
/// else are shaded at every pixel. False: none of the chunk is.
bool try_strides(const Frame& frame, Chunk& chunk);
/// In all of the triangle: 1, 2, 4, 8 or 16. Found when a triangle of the chunk is first asked for,
/// for a whole vector of them, and kept for the frame.
int stride_of(const Frame& frame, const DrawnTriangle& drawn);

}  // namespace scanlit
