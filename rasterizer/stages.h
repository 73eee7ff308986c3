// The seam: somebody else's stage in place of the engine's own, as in an assignment that asks for
// one. A frame with RenderSettings::stages is drawn by staged_frame.cpp, which reads from top to
// bottom: one triangle after the other, each stage a call of this table, one thread, no tiles. With
// an empty table coverage, ids and depth are the same to the bit as without any, and colours within
// rounding.
//
// All pixels are those of the picture; fragments of a span stand side by side in one row.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "rasterizer/pipeline.h"

namespace scanlit {

/// `begin` <= x < `end`, in row y.
using EmitSpan = std::function<void(int y, int begin, int end)>;

/// A piece of a triangle, on its way through stages (7) to (9).
struct StagedPiece {
  const Object* object;
  std::uint32_t object_index;  // in Scene::objects
  std::uint32_t triangle;      // in the mesh
  bool back_facing;            // its normals are to be flipped
  ScreenTriangle screen;
  ClippedTriangle corners;  // where they lie in the mesh's triangle
};

/// Null: the engine's own.
struct StageFunctions {
  /// (4) Appends what is inside of the clip volume (pipeline.h) and the guard band. Of every
  /// triangle whose coordinates are finite and below 1e18.
  std::function<void(const ClipVertex (&triangle)[3], const Viewport& viewport,
                     std::vector<ClippedTriangle>& pieces)>
      clip{};

  /// (7) The spans of pixels in `picture` that a piece with an area covers, in any order. What
  /// leaves the picture is cut off.
  std::function<void(const ScreenTriangle& triangle, const Rect& picture, const EmitSpan& emit)>
      spans{};

  /// (7) Depths of a span's fragments, from pixel (x, y) on.
  std::function<void(const ScreenTriangle& triangle, int x, int y, std::span<float> depth)> depth{};

  /// (7) Which fragments are seen, given what the picture holds at their pixels (0: nothing yet).
  std::function<void(std::span<const float> depth, std::span<const float> there,
                     std::span<std::uint8_t> seen)>
      depth_test{};

  /// (8) Barycentric coordinates of corners 1 and 2 of the mesh's triangle.
  std::function<void(const StagedPiece& piece, int x, int y, std::span<float> b1,
                     std::span<float> b2)>
      barycentric{};

  /// (9) Linear radiance of fragments that are seen. Where it is somebody else's, the framebuffer's
  /// planes of normals and parts stay empty.
  std::function<void(const StagedPiece& piece, std::span<const float> b1, std::span<const float> b2,
                     std::span<Rgb<float>> colour)>
      shade{};
};

/// A frame by the table in `settings`. Throws Error where it has more than one sample a pixel or
/// the framebuffer is not in linear_float; `threads`, `skips`, `tolerance`, `reuse` and `probe`
/// mean nothing to it. All else has been checked: Renderer::render() is what calls it.
FrameStats render_staged(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                         Framebuffer& framebuffer);

}  // namespace scanlit
