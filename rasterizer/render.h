// One frame: the stages of pipeline.h, run in order.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "rasterizer/camera.h"
#include "rasterizer/framebuffer.h"
#include "rasterizer/scene.h"

namespace scanlit {

class FrameProbe;
struct StageFunctions;

/// How attributes are interpolated across a triangle: right, or linearly on the screen as the
/// classical scanline hardware did, to show its error.
enum class Interpolation { perspective, screen_linear };

/// Work that no picture shows. Each is a switch, on by default; with it off the work is done and
/// the picture is the same to the bit, which is how the skip benchmark measures what it saves.
struct Skips {
  bool outside_objects = true;       // objects whose bounds lie outside the view
  bool outside_clusters = true;      // of the rest, clusters of triangles outside the view
  bool back_facing_clusters = true;  // clusters whose triangles all face away
  bool hidden_clusters = true;       // objects and clusters behind others' few large triangles
  bool unseen_triangles = true;      // back faces, and triangles between the sample positions,
                                     // before they are sorted into tiles
  bool clip_tests = true;            // of clusters that lie wholly inside of the guard band
  bool hidden_triangles = true;      // those behind a tile's coarse depth; nearest first
  bool hidden_fragments = true;      // off: every fragment is shaded that is nearest when it is
                                     // drawn, not only those that stay (with one sample a pixel)
  bool empty_pixels = true;          // rows and columns of a tile that no triangle touches
  bool dark_lights = true;           // lights that do not reach a span, or stand behind it
  bool far_directions = true;        // per-point L and V where viewer and light are infinitely far
  bool unused_attributes = true;     // what the shading of an object does not look at

  friend bool operator==(const Skips&, const Skips&) = default;
};

/// The switches by name, for programs that offer them.
struct SkipSwitch {
  const char* name;  // such as "outside-objects"
  bool Skips::*member;
};
std::span<const SkipSwitch> skip_switches();

struct RenderSettings {
  int samples = 1;  // coverage samples a pixel: 1, 4, 8 or 16
  int threads = 0;  // 0 (all cores)..1024; the picture does not depend on it
  Interpolation interpolation = Interpolation::perspective;
  bool clamp_vertex_colours = false;  // Gouraud: clamp to [0,1] at the vertices, as OpenGL's
                                      // fixed-point colours were
  Skips skips{};
  // By how much a pixel may be off, in codes: 255 times the colour as the framebuffer encodes it
  // (a float framebuffer's as sRGB would). 0: all is evaluated; else only as much as keeps what is
  // left out within this bound, of all kinds together. Where parts, normals or costs are asked for,
  // all is.
  double tolerance = 0;
  bool reuse = false;  // Renderer: what has not changed since its last frame stands. Costs memory.
  std::function<void(double)> progress{};  // called with 0..1, from any thread, one call at a time
  FrameProbe* probe = nullptr;             // looks on while the frame is drawn: see frame_probe.h
  const StageFunctions* stages = nullptr;  // others in place of the engine's own: see stages.h
};

/// What a frame's time is measured for, in order.
enum class Stage { assembly, light_vertices, scan_conversion, resolve, shading, count };
const char* name(Stage stage);

/// What a frame did. Counts do not depend on the number of threads; seconds are summed over them.
struct FrameStats {
  std::int64_t vertices = 0;  // transformed; those that clusters share, more than once
  std::int64_t objects_outside = 0, objects_hidden = 0;
  std::int64_t clusters = 0;  // of objects that are not outside
  std::int64_t clusters_outside = 0, clusters_back_facing = 0, clusters_hidden = 0;
  std::int64_t triangles = 0;    // submitted; = outside + behind + back_facing + no_pixel + drawn
  std::int64_t outside = 0;      // wholly outside the view
  std::int64_t behind = 0;       // in clusters that are hidden as a whole
  std::int64_t back_facing = 0;  // facing away, where only front faces are drawn
  std::int64_t no_pixel = 0;     // zero area on the screen, or between the sample positions
  std::int64_t drawn = 0;        // sorted into tiles, for scan conversion
  std::int64_t clipped = 0;      // of them, those that had to be cut
  std::int64_t hidden = 0;       // of them, times dropped by the coarse depth, once a tile
  std::int64_t fragments = 0;    // shaded: pixels covered, and more where samples differ
  std::int64_t covered_pixels = 0;
  std::int64_t evaluations = 0;          // asked for: points times lights
  std::int64_t evaluations_skipped = 0;  // of them, because the light does not reach the point
  std::int64_t tiles_kept = 0;           // that stand from the last frame
  std::int64_t spans = 0;                // of points that were lit, once a light
  std::array<double, std::size_t(Stage::count)> seconds{};
  double wall_seconds = 0;
  int threads = 0;
};

/// Draws frames, and keeps its memory from one to the next: the first is slower. Results are kept
/// only where RenderSettings::reuse asks for it. One frame at a time.
class Renderer {
 public:
  Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Draws the scene into the framebuffer, replacing what it held. With settings.reuse
  /// nobody else may have changed its pixels since this Renderer drew them (Framebuffer::frame).
  /// Throws Error where camera, scene or settings are out of range.
  FrameStats render(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                    Framebuffer& framebuffer);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One frame, by a Renderer of its own.
FrameStats render(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                  Framebuffer& framebuffer);

}  // namespace scanlit
