// How far a picture is from what it should be.
//
//   linear      difference of radiance, of any channel
//   steps       the same in 8-bit steps of the encoding, both sides clamped to [0, 1] as a file
//               clamps them, but not yet rounded to whole steps
//   differing   pixels of which a channel is another code after rounding
//   perceived   what an observer notices who flips between the two: see flip.h
//
// Silhouette pixels are kept apart: near them two pictures of one object may see different parts
// of it, and no bound holds.
#pragma once

#include "rasterizer/image.h"
#include "rasterizer/reference/reference.h"

namespace scanlit {

/// Over some of a picture's pixels; 0 where there are none.
struct PixelErrors {
  std::int64_t pixels = 0, differing = 0;
  double max_linear = 0, rms_linear = 0;  // radiance; rms over pixels and channels
  double max_steps = 0, rms_steps = 0;    // 8-bit steps
};

struct PictureError {
  PixelErrors interior, silhouette;  // of pixels in which either picture sees something
  std::int64_t different_ids = 0;    // of them, those that see another object or another triangle
  double peak = 0;                   // the reference's largest channel, linear
};

/// Pixels that see an edge or lie beside one (in the 3 x 3 around), in either picture: another
/// object, or none; a distance that leaps by more than 10 pixel widths, as it does at contours and
/// on what is seen within 6 degrees of edge-on; normals more than 30 degrees apart, as at a crease
/// or where one part passes through another. Also those at which the two pictures see another part:
/// normals as far apart, or distances by 50 pixel widths, which a coarse mesh alone does not reach.
/// Pictures of equal size, as render_reference and render_analytic give them.
std::vector<bool> silhouettes(const ExactPicture& a, const ExactPicture& b, const Camera& camera);

/// Pictures of equal size. `silhouette` has an element a pixel; empty: there is none. A pixel in
/// which only one picture sees something is always one. A picture without any id is taken to see
/// what the reference sees.
PictureError compare(const ExactPicture& reference, const ExactPicture& picture, Encoding encoding,
                     const std::vector<bool>& silhouette = {});

/// What an 8-bit file makes of linear light, as a fraction 0..1 that is not rounded yet.
double encoded(double linear, Encoding encoding);

}  // namespace scanlit
