// The comparison's scenes, drawn by Scanlit into 8-bit pixels.
#pragma once

#include "bench_scenes.h"
#include "picture_difference.h"
#include "rasterizer/framebuffer.h"
#include "rasterizer/render.h"

namespace scanlit::bench {

/// Linear light, clamped to [0, 1] and rounded to 8 bits, in parallel. rgba has room for the
/// framebuffer's pixels, 4 bytes each.
void to_rgba8(const Framebuffer& framebuffer, int threads, std::uint8_t* rgba);

/// What a bench's frame is drawn into.
constexpr Planes picture_planes{};

/// point_lights(count) of the scenes' definition.
std::vector<Light> scanlit_lights(int count);

/// The scene in frame 0.
Scene scanlit_scene(const BenchScene& scene);
Camera scanlit_camera(const BenchScene& scene);
/// Moves them to another frame.
void pose(const BenchScene& scene, int frame, Scene& posed, Camera& camera);

class ScanlitSide {
 public:
  explicit ScanlitSide(int threads);

  /// `reuse`: what has not changed since the last frame stands.
  void prepare(const BenchScene& scene, bool reuse = false);
  /// Returns when the pixels are in picture().
  void draw(const BenchScene& scene, int frame);

  const Picture& picture() const { return picture_; }
  /// Of the last frame: its stages, in seconds summed over the threads.
  const FrameStats& stats() const { return stats_; }
  /// Of the last frame: to_rgba8(), by the clock.
  double conversion_seconds() const { return conversion_seconds_; }

 private:
  RenderSettings settings_;
  Renderer renderer_;
  Scene scene_;
  Camera camera_;
  Framebuffer framebuffer_{picture_width, picture_height, picture_planes};
  Picture picture_ = Picture(4 * framebuffer_.pixel_count());
  FrameStats stats_;
  double conversion_seconds_ = 0;
};

}  // namespace scanlit::bench
