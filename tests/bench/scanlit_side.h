// The comparison's scenes, drawn by Scanlit into 8-bit pixels.
#pragma once

#include "bench_scenes.h"
#include "picture_difference.h"
#include "rasterizer/framebuffer.h"
#include "rasterizer/render.h"

namespace scanlit::bench {

/// What a bench's frame is drawn into.
constexpr Planes picture_planes{.format = ColourFormat::linear_8bit};

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

  const Picture& picture() const { return framebuffer_.rgba8; }
  /// Of the last frame: its stages, in seconds summed over the threads.
  const FrameStats& stats() const { return stats_; }

 private:
  RenderSettings settings_;
  Renderer renderer_;
  Scene scene_;
  Camera camera_;
  Framebuffer framebuffer_{picture_width, picture_height, picture_planes};
  FrameStats stats_;
};

}  // namespace scanlit::bench
