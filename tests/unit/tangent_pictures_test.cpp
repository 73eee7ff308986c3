// (9) Tangents in a picture: those of every fragment, from any field, whatever the threads.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>

#include "rasterizer/shapes.h"
#include "tests/unit/probe.h"
#include "tests/unit/tangent_checks.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

/// Shows the tangent as the diffuse part and the normal as the glossy one, in world space.
std::shared_ptr<Probe> show_tangent() {
  return std::make_shared<Probe>(Needs{.frame = true}, [](const DirectionSpan& in, std::size_t i) {
    return std::array<float, 6>{in.tangent[0][i], in.tangent[1][i], in.tangent[2][i],
                                in.normal[0][i],  in.normal[1][i],  in.normal[2][i]};
  });
}

Picture tangents_in_picture(const std::string& shape, const Tangents& tangents, Shading shading,
                            RenderSettings settings = {}) {
  Object object = object_of(std::make_shared<Mesh>(make_shape(shape)), White(), shading);
  object.material.model = show_tangent();
  object.material.tangents = tangents;
  object.world_from_object = glm::rotate(glm::mat4(1), 0.9f, glm::vec3(1, 0.3f, 0));
  settings.skips.dark_lights = false;  // tangents are shown where no light falls, too
  return picture_of(scene_of({object}), Camera(), 96, 96, settings);
}

TEST(TangentPictures, AreUnitAndInTheSurfaceAtEveryFragment) {
  for (const char* shape : {"sphere:8", "cylinder:12", "cone:12", "cube", "plane", "torus:9"})
    for (const TangentField field :
         {TangentField::around, TangentField::along, TangentField::texcoord})
      for (const Shading shading : {Shading::phong, Shading::flat}) {
        const Picture picture = tangents_in_picture(shape, {.field = field}, shading);
        ASSERT_GT(picture.stats.covered_pixels, 500);
        const Framebuffer& f = picture.framebuffer;
        for (std::size_t i = 0; i < f.pixel_count(); ++i) {
          if (f.colour[4 * i + 3] == 0) continue;
          const glm::vec3 t(f.diffuse[3 * i], f.diffuse[3 * i + 1], f.diffuse[3 * i + 2]);
          const glm::vec3 n(f.glossy[3 * i], f.glossy[3 * i + 1], f.glossy[3 * i + 2]);
          ASSERT_TRUE(lies_in_surface(t, n)) << shape << ' ' << int(field) << ' ' << int(shading);
        }
      }
}

TEST(TangentPictures, ByTexcoordAndAroundAgreeOnASphere) {
  const Picture by_position = tangents_in_picture("sphere:64", Tangents{}, Shading::phong);
  const Picture by_texcoord =
      tangents_in_picture("sphere:64", {.field = TangentField::texcoord}, Shading::phong);
  int compared = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      if (by_position.triangle(x, y) == no_id) continue;
      const float *p = &by_position.framebuffer.diffuse[3 * by_position.index(x, y)],
                  *q = &by_texcoord.framebuffer.diffuse[3 * by_texcoord.index(x, y)];
      compared += p[0] * q[0] + p[1] * q[1] + p[2] * q[2] > 0.99f;
    }
  // Apart from the triangles at the poles, over which u is not linear.
  EXPECT_GT(compared, 0.98 * double(by_position.stats.covered_pixels));
}

TEST(TangentPictures, DoNotDependOnThreads) {
  RenderSettings one, four;
  one.threads = 1, four.threads = 4;
  for (const TangentField field :
       {TangentField::around, TangentField::along, TangentField::texcoord}) {
    const Tangents tangents{.field = field, .axis = {0.3f, 1, 0}, .centre = {0.1f, 0, 0}};
    EXPECT_EQ(
        tangents_in_picture("cylinder:40", tangents, Shading::phong, one).framebuffer.diffuse,
        tangents_in_picture("cylinder:40", tangents, Shading::phong, four).framebuffer.diffuse);
  }
}

}  // namespace
}  // namespace scanlit
