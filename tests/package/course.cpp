// What a student writes outside of Scanlit's own tree: one model, in one file, registered by its
// last line.
#include <cstdio>

#include "models/formula.h"
#include "rasterizer/image.h"
#include "rasterizer/render.h"
#include "rasterizer/shapes.h"

namespace scanlit::models {

struct Minnaert {
  Rgb<double> kd{0.8};
  double k = 1.5;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = kd * (c.n_l * pow(max(c.n_l * c.n_v, T(0)), T(k - 1))), .glossy = {}};
  }

  static Description<Minnaert> describe() {
    return {.name = "minnaert",
            .title = "Minnaert (the moon)",
            .source = "Minnaert 1941, The reciprocity principle in lunar photometry, eq. 3",
            .reciprocal = true,
            .energy_bounded = true,
            .parameters = {{"kd", &Minnaert::kd, 0, 1, "diffuse reflectance"},
                           {"k", &Minnaert::k, 1, 3, "limb darkening"}}};
  }
};

inline const Registered<Minnaert> minnaert_registered;

}  // namespace scanlit::models

int main() {
  using namespace scanlit;
  Scene scene;
  scene.lights.emplace_back();
  Object& sphere = scene.objects.emplace_back();
  sphere.mesh = std::make_shared<const Mesh>(make_shape("sphere"));
  sphere.material.model = models::make("minnaert:kd=.9,k=2").model;
  Framebuffer framebuffer(64, 64);
  const FrameStats stats = render(scene, Camera{}, RenderSettings{}, framebuffer);
  write_image("course.png", framebuffer);
  std::printf("%lld pixels\n", static_cast<long long>(stats.covered_pixels));
  return stats.covered_pixels > 1000 && framebuffer.colour[4 * (32 * 64 + 32)] > 0.5f ? 0 : 1;
}
