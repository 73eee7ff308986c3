// New idea: on the screen not u is linear but u / w, and so is 1 / w: interpolate both, and divide.
// Builds on: lesson 3, barycentric coordinates; lesson 6, perspective.
// Try: --tilt 0, where both are right; --tilt 80; --squares 20: where is the error largest?
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
/// Texture coordinates at a point of the screen. `b` are its barycentric coordinates there, that is
/// each corner's share of the triangle's area on the screen.
glm::dvec2 screen_linear(const double (&b)[3], const glm::dvec2 (&uv)[3]) {
  return b[0] * uv[0] + b[1] * uv[1] + b[2] * uv[2];
}
glm::dvec2 perspective(const double (&b)[3], const glm::dvec2 (&uv)[3], const double (&w)[3]) {
  glm::dvec2 uv_by_w(0);
  double one_by_w = 0;
  for (int k = 0; k < 3; ++k) {
    uv_by_w += b[k] * uv[k] / w[k];
    one_by_w += b[k] / w[k];
  }
  return uv_by_w / one_by_w;
}
// end of new idea

Rgb<double> checker(glm::dvec2 uv, int squares) {
  const bool dark = (int(std::floor(uv.x * squares)) + int(std::floor(uv.y * squares))) % 2;
  return dark ? ink::blue : ink::paper;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Attributes are divided by w before they are interpolated.", 1500, 1000);
  double tilt_deg = 55;
  int squares = 8;
  lesson.knob("--tilt", tilt_deg, {0, 85}, "of the board, away from the viewer, in degrees");
  lesson.knob("--squares", squares, {1, 100}, "on each side of the board");

  return lesson.run(argc, argv, [&] {
    const Object board = studio::make_object("plane:1", "lambert");
    Camera camera;
    const double tilt = glm::radians(tilt_deg);
    camera.eye = glm::dvec3(.25 * std::sin(tilt), -std::sin(tilt), std::cos(tilt)) * 2.0;
    camera.up = {0, 1, 1};
    camera.fov_deg = 55;
    camera.target = {.06 * std::sin(tilt), -.46 * std::sin(tilt), 0};
    double largest = 0;
    const auto draw = [&](int panel, int width, int height) {
      constexpr int fine = 3;
      Framebuffer image = studio::blank_picture(width * fine, height * fine, ink::slate);
      const auto clip = studio::clip_space(board, camera, double(width) / height);
      for (std::size_t t = 0; t < board.mesh->triangle_count(); ++t) {
        const ScreenTriangle triangle = studio::on_screen(clip, *board.mesh, t, image);
        const auto& [p, q, r] = triangle.vertices;
        glm::dvec2 uv[3];
        double w[3], area = double(triangle.twice_area);
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t vertex = board.mesh->indices[3 * t + k];
          uv[k] = board.mesh->texcoords[vertex];
          w[k] = clip[vertex].w;
        }
        studio::for_each_pixel(triangle, image, [&](int i, int j) {
          const int x = i * subpixel + half_pixel, y = j * subpixel + half_pixel;
          const double b[3] = {double(edge_function(q, r, x, y)) / area,
                               double(edge_function(r, p, x, y)) / area,
                               double(edge_function(p, q, x, y)) / area};
          const glm::dvec2 wrong = screen_linear(b, uv), right = perspective(b, uv, w);
          const double error = squares * glm::distance(wrong, right);
          largest = std::max(largest, error);
          studio::put(image, i, j,
                      panel == 0   ? checker(wrong, squares)
                      : panel == 1 ? checker(right, squares)
                                   : ink::pale + (ink::vermilion - ink::pale) * (error / largest));
        });
      }
      return studio::reduced(image, fine);
    };
    Framebuffer sheet =
        studio::panels(lesson.width(), lesson.height(), 2,
                       {"u and v linear on the screen", "u / w, v / w and 1 / w", "error"}, draw);
    lesson.figure("largest error, in squares", studio::fixed(largest, 2));
    return sheet;
  });
}
