// New idea: each pixel remembers how near its colour is, and only what is nearer may replace it.
// Builds on: lesson 4, spans; lesson 6, the camera.
// Try: --turn 25; is there an order of the rings that needs no depth buffer? And of triangles?
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/drawing/stages.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/sheet_layout.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// One depth for each pixel: 0 where nothing is yet, and larger is nearer, up to 1.
struct DepthBuffer {
  int width;
  std::vector<float> depth;

  /// Whether this fragment is in front of all that came before it; then it is what is there now.
  bool is_nearest(int x, int y, float fragment_depth) {
    float& nearest = depth[std::size_t(y) * width + x];
    if (fragment_depth <= nearest) return false;
    nearest = fragment_depth;
    return true;
  }
};
// end of new idea

/// Draws an object's triangles in the order of its mesh; without a depth buffer the last one wins.
void draw(const Object& object, const Camera& camera, const Rgb<double>& colour,
          DepthBuffer* buffer, Framebuffer& image) {
  const auto clip = studio::clip_space(object, camera, double(image.width) / image.height);
  for (std::size_t t = 0; t < object.mesh->triangle_count(); ++t) {
    const ScreenTriangle triangle = studio::on_screen(clip, *object.mesh, t, image);
    const glm::vec3& normal = object.mesh->normals[object.mesh->indices[3 * t]];
    const glm::dvec3 turned(object.world_from_object * glm::vec4(normal, 0));
    const double light = 0.2 + 0.8 * std::max(0.0, glm::dot(turned, glm::dvec3(-.5, .6, .62)));
    const DepthPlane depth(triangle);  // depth is linear on the screen
    studio::for_each_pixel(triangle, image, [&](int x, int y) {
      if (!buffer || buffer->is_nearest(x, y, depth.at(x, y)))
        studio::put(image, x, y, colour * light);
    });
  }
}

int main(int argc, char** argv) {
  studio::Lesson lesson("A depth buffer decides pixel by pixel.", 1800, 640);
  double turn = -95;
  lesson.knob("--turn", turn, studio::any_angle_deg, "of the rings, in degrees");

  return lesson.run(argc, argv, [&] {
    Scene scene;  // three rings that cut into each other: no order of them is right
    for (int k = 0; k < 3; ++k) {
      Object ring = studio::make_object("torus:40", "lambert");
      const float angle = float(glm::radians(turn + 120 * k));
      ring.world_from_object = glm::translate(
          glm::rotate(glm::mat4(1), angle, glm::vec3(.1, 1, .25)), glm::vec3(.62, 0, 0));
      scene.objects.push_back(ring);
    }
    const Rgb<double> colours[] = {ink::orange, ink::sky, ink::green};
    Framebuffer last_drawn;
    const auto draw_panel = [&](int panel, int width, int height) {
      constexpr int fine = 3;  // samples a side, of which a pixel is the mean
      const Camera camera = studio::fitted({.eye = {0, 3, 3.4}}, scene, double(width) / height);
      Framebuffer image = studio::blank_picture(width * fine, height * fine, ink::slate);
      DepthBuffer buffer{image.width, std::vector<float>(image.pixel_count())};
      for (std::size_t k = 0; k < 3; ++k)
        draw(scene.objects[k], camera, colours[k], panel ? &buffer : nullptr, image);
      if (panel == 0) last_drawn = image;
      double covered = 0, wrong = 0;
      for (std::size_t i = 0; i < image.pixel_count(); ++i)
        if (buffer.depth[i] > 0)
          ++covered, wrong += image.colour[4 * i] != last_drawn.colour[4 * i];
      if (panel == 1)
        lesson.figure("wrong without a depth buffer, in % of the covered pixels",
                      studio::fixed(100 * wrong / covered, 0));
      for (int i = 0; i < int(buffer.depth.size()) && panel == 2; ++i)
        if (const double depth = buffer.depth[i]; depth > 0)
          studio::put(image, i % image.width, i / image.width, Rgb<double>(depth));
      return studio::reduced(image, fine);
    };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {"the last one drawn", "the nearest one", "how near it is"}, draw_panel);
  });
}
