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
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

constexpr double rounding_codes = 0.1;  // of all three, together
constexpr int max_stride = 16;

/// Whether an object's fragments may be shaded so at all: per fragment, in colours alone.
bool may_stride(const Frame& frame, const Draw& draw);

/// Whether it is better bounded tile by tile.
bool is_large(const DrawnTriangle& drawn);
/// 1 (every pixel), 2, 4, 8 or 16: in a rectangle of pixels.
int stride_in(const Frame& frame, const DrawnTriangle& drawn, const Rect& pixels);

/// In all of the triangle. Found when a triangle of the chunk is first asked for, for a
/// whole vector of them, and kept for the frame.
int stride_of(const Frame& frame, const DrawnTriangle& drawn);

}  // namespace scanlit
