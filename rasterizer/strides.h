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
// Assumed is that Batch evaluates f to within `rounding_codes` of a code, of all three pixels
// together: the tests hold every model to less. And the same budget pays for codes that are only
// near_codes right (pixel_codes.h), of all pixels, interpolated or not: of what is left of a frame
// under one light a third were the powers of sRGB's encoding.
//
// Bounds are dear: those of a vector of triangles under one light take about as long as lighting 80
// vectors of pixels. So a few triangles of each chunk are tried, and where little is spared nothing
// else is bounded. The frame alone decides that, not who draws which tile.
//
// How many times faster frames are with E = 1 than with 0, and would be were shading free
// (tests/bench/run tolerance; AVX-512, one thread); which share of the pixels is lit; and which
// would be with the best stride for each 32 pixels of a row:
//
//        ratio  free  lit  best         ratio  free  lit  best         ratio  free  lit  best
//   R5    2.7    25   .21   .12    S2    1.24  2.0   .26   .11    R7    1.03  2.9  1.00   .13
//   S6    2.0   8.6   .33   .12    R2    1.11  1.8   .84   .12    S3    1.03  2.2   .65   .10
//   R0    1.74  3.2   .21   .12    R1    1.11  1.7  1.00   .11    S5F   1.04  1.3   .16
//   R6    1.57   24   .57   .12    R4    1.09  8.2   .91   .21    R9    1.05  1.6  1.00   .32
//   R8    1.25  3.1   .47   .19    R3    1.04  5.6  1.00   .42    S8P   1.00  1.3  1.00   .18
//
// Where shading is more than half of the frame that is 1.39 in the geometric mean, not yet the 1.5
// that is wanted. What is missing is a cheap proof where a triangle is small or its lobe sharp: a
// bound takes as long as lighting 80 pixels, hence a cell must have some 250; on a sphere of 400
// pixels a cell of 16 by 16 holds normals that lie .04 rad apart, over which the bounds of a
// lobe's curvature are 20 times what it is (Blinn-Phong's of n = 32 3 times), over .16 rad 300
// times. What would help: intervals of the first and second derivative in place of their size, so
// that (e^x)'' = e^x (x'^2 + x'') may cancel. Tried and not kept:
//
//   32 pixels of a row and rows below, whatever their triangles, with the bends of N, V and P
//   measured pixel by pixel: .44 (R5) to .99 (R3) lit; such a cone holds a lobe of some light
//   rectangles of large triangles lit on a lattice: .03 of R5's cube in place of .09, but bounds in
//   all directions cost what that saves
//   bounds of tangents (half of R6 and a seventh of R4 are Ashikhmin-Shirley's): its lobe's
//   curvature comes out 2,500 times too large, and 25 to 130 times where the exponent is not left
//   an interval of its own; R6 lights as many pixels as without
//
// Not tried: many lights bounded as one; fine meshes evaluated at vertices (of R7's pixels one in
// ten; the bounds of 64 triangles at a time would cost a quarter of the frame).
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

constexpr double rounding_codes = 0.1;  // of all three, together
constexpr int max_stride = 16;

/// Whether codes need only be near (pixel_codes.h).
bool may_be_near(const Frame& frame);

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
