// What the tests of surface inputs share: a model that shows in a picture what it is given, and a
// square to put it on.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "tests/unit/test_scene.h"

namespace scanlit::test {

/// A model that shows six numbers a point, and counts how it is called.
class Probe : public ReflectionModel {
 public:
  using Show = std::function<std::array<float, 6>(const DirectionSpan&, std::size_t)>;

  Probe(const Needs& needs, Show show) : needs_(needs), show_(std::move(show)) {}

  Needs needs() const override { return needs_; }

  /// Parameter k of point i is its number k's share: position plus k.
  void evaluate_parameters(const PointSpan& points, float* const* parameters) const override {
    ++parameter_calls;
    for (std::size_t k = 0; k < needs_.parameters; ++k)
      for (std::size_t i = 0; i < (points.size + max_lanes - 1) / max_lanes * max_lanes; ++i)
        parameters[k][i] = points.object_position[0][i] + float(k);
  }

  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override {
    ++calls;
    for (std::size_t i = 0; i < in.size; ++i) {
      const std::array<float, 6> shown = show_(in, i);
      for (std::size_t c = 0; c < 3; ++c)
        out.diffuse[c][i] = shown[c], out.glossy[c][i] = shown[3 + c];
    }
  }
  Reflection<double> evaluate(const Vec3<double>&, const Vec3<double>&,
                              const SurfacePoint<double>&) const override {
    return {};
  }
  Reflection<float> evaluate(const Vec3<float>&, const Vec3<float>&,
                             const SurfacePoint<float>&) const override {
    return {};
  }

  mutable std::atomic<int> calls = 0, parameter_calls = 0;

 private:
  Needs needs_;
  Show show_;
};

inline Object probed_object(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Probe> probe,
                            Shading shading = Shading::phong) {
  Object object = object_of(std::move(mesh), White(), shading);
  object.material.model = std::move(probe);
  return object;
}

/// The six numbers at a pixel.
inline std::array<float, 6> shown(const Picture& picture, int x, int y) {
  const float* diffuse = &picture.framebuffer.diffuse[3 * picture.index(x, y)];
  const float* glossy = &picture.framebuffer.glossy[3 * picture.index(x, y)];
  return {diffuse[0], diffuse[1], diffuse[2], glossy[0], glossy[1], glossy[2]};
}

/// A square that fills the picture of pixel_camera(size, size).
inline std::shared_ptr<Mesh> square(int size) {
  auto mesh = triangle_soup(
      on_screen({{0, 0, 0.5f}, {0, size, 0.5f}, {size, 0, 0.5f}, {size, size, 0.5f}}));
  mesh->indices = {0, 1, 2, 3, 2, 1};
  return mesh;
}

}  // namespace scanlit::test
