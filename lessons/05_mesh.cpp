// New idea: a mesh is a list of points and a list of triples; dropping z puts it on the screen.
// Builds on: lesson 2, lines; lesson 4, spans.
// Try: --mesh teapot:2; --mesh trefoil; --turn -60: which triangles should not be in front?
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stages.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "rasterizer/shapes.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// Orthographic: x and y become pixels, and z is forgotten. y grows upwards, rows downwards.
glm::dvec2 to_pixels(const glm::vec3& point, double scale, const Framebuffer& image) {
  return {image.width / 2.0 + scale * point.x, image.height / 2.0 - scale * point.y};
}

/// Every triangle that faces us, in the order of the list. Returns how many do.
int draw(const Mesh& mesh, const glm::mat4& turn, double scale, Framebuffer& image) {
  int facing = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    ScreenVertex corner[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3& position = mesh.positions[mesh.indices[3 * t + k]];
      const glm::dvec2 p = to_pixels(turn * glm::vec4(position, 1), scale, image);
      corner[k] = {int(p.x * subpixel), int(p.y * subpixel), 0, 1};
    }
    const ScreenTriangle triangle = screen_triangle(corner[0], corner[1], corner[2]);
    facing += triangle.twice_area > 0;
    const double shade = 0.25 + 0.09 * double(t * 7 % 9);  // neighbours differ
    studio::for_each_pixel(triangle, image,
                           [&](int x, int y) { studio::put(image, x, y, ink::orange * shade); });
  }
  return facing;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("A mesh is points and triples of them.", 1700, 600);
  std::string shape = "teapot:5";
  double turn_deg = -25;
  lesson.knob("--mesh", shape, "a shape");
  lesson.knob("--turn", turn_deg, studio::any_angle_deg, "about the upright axis, in degrees");

  return lesson.run(argc, argv, [&] {
    const Mesh mesh = make_shape(shape);
    glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(24.f), glm::vec3(1, 0, 0));
    turn = glm::rotate(turn, float(glm::radians(turn_deg)), glm::vec3(0, 1, 0));
    glm::vec2 extent(0);
    for (const glm::vec3& position : mesh.positions)
      extent = glm::max(extent, glm::abs(glm::vec2(turn * glm::vec4(position, 1))));
    const auto draw_panel = [&](int panel, int width, int height) {
      constexpr int fine = 3;  // samples a side, of which a pixel is the mean
      const double scale = .47 * std::min(width / extent.x, height / extent.y);
      if (panel == 1) {
        Framebuffer image = studio::blank_picture(width * fine, height * fine, ink::slate);
        lesson.figure("triangles that face us",
                      std::to_string(draw(mesh, turn, scale * fine, image)));
        return studio::reduced(image, fine);
      }
      const Framebuffer blank(width, height);
      studio::Canvas canvas(width, height, {width, height}, ink::slate);
      for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const auto at = [&](std::size_t k) {
          return to_pixels(turn * glm::vec4(mesh.positions[mesh.indices[k]], 1), scale, blank);
        };
        if (mesh.indices[i] < mesh.indices[next])  // each edge once, of its two triangles
          canvas.line(at(i), at(next), ink::sky, 2);
      }
      lesson.figure("points", std::to_string(mesh.positions.size()));
      lesson.figure("triangles", std::to_string(mesh.triangle_count()));
      return canvas.finish();
    };
    return studio::panels(lesson.width(), lesson.height(), 2,
                          {"points, joined by threes", "triangles, in the order of the list"},
                          draw_panel);
  });
}
