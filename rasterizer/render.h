// One frame: the stages of pipeline.h, run in order.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "rasterizer/camera.h"
#include "rasterizer/framebuffer.h"
#include "rasterizer/scene.h"

namespace scanlit {

/// How attributes are interpolated across a triangle: right, or linearly on the screen as the
/// classical scanline hardware did, to show its error.
enum class Interpolation { perspective, screen_linear };

struct RenderSettings {
  int samples = 1;  // coverage samples a pixel: 1, 4, 8 or 16
  int threads = 0;  // 0 (all cores)..1024; the picture does not depend on it
  Interpolation interpolation = Interpolation::perspective;
  bool clamp_vertex_colours = false;       // Gouraud: clamp to [0,1] at the vertices, as OpenGL's
                                           // fixed-point colours were
  std::function<void(double)> progress{};  // called with 0..1, from any thread, one call at a time
};

/// What a frame's time is measured for, in order.
enum class Stage { vertices, assembly, light_vertices, scan_conversion, resolve, shading, count };
const char* name(Stage stage);

/// What a frame did. Counts do not depend on the number of threads; seconds are summed over them.
struct FrameStats {
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;    // submitted; = outside + back_facing + no_pixel + drawn
  std::int64_t outside = 0;      // wholly outside the view
  std::int64_t back_facing = 0;  // facing away, where only front faces are drawn
  std::int64_t no_pixel = 0;     // zero area on the screen, or between the sample positions
  std::int64_t drawn = 0;        // scan-converted
  std::int64_t clipped = 0;      // of them, those that had to be cut
  std::int64_t fragments = 0;    // shaded: pixels covered, and more where samples differ
  std::int64_t covered_pixels = 0;
  std::int64_t evaluations = 0;  // points at which a reflection model was evaluated, per light
  std::int64_t spans = 0;        // virtual calls in which they were
  std::array<double, std::size_t(Stage::count)> seconds{};
  double wall_seconds = 0;
  int threads = 0;
};

/// Draws the scene into the framebuffer, replacing what it held.
/// Throws Error where camera, scene or settings are out of range.
FrameStats render(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                  Framebuffer& framebuffer);

}  // namespace scanlit
