// New idea: a triangle that reaches behind the eye is cut where it crosses the near plane.
// Builds on: lesson 6, perspective.
// Try: --turn 0; --near 1.5: what does the near plane cut away, and could it be too near?
#include <cmath>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stages.h"
#include "lessons/studio/lesson.h"
#include "rasterizer/shapes.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
using Polygon = std::vector<glm::dvec4>;  // corners in clip space

/// What of a polygon is before the near plane, where w - z >= 0 (depth z / w is 1 on it): walk
/// around; keep the corners inside, and add the point where an edge crosses.
Polygon clipped(const Polygon& polygon) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double inside_a = a.w - a.z, inside_b = b.w - b.z;
    if (inside_a >= 0) result.push_back(a);
    if ((inside_a >= 0) != (inside_b >= 0))
      result.push_back(a + (b - a) * (inside_a / (inside_a - inside_b)));
  }
  return result;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("What reaches behind the eye is cut at the near plane.", 1800, 680);
  double turn_deg = 28, near = 0.05;
  lesson.knob("--turn", turn_deg, studio::any_angle_deg, "of the viewer, in degrees");
  lesson.knob("--near", near, {1e-6, 10}, "distance of the near plane; the room is 2 wide");

  return lesson.run(argc, argv, [&] {
    // A room, seen from inside: eight triangles a wall.
    Object room;
    room.mesh = std::make_shared<const Mesh>(make_shape("cube:2"));
    Camera camera;
    const double turn = glm::radians(turn_deg);
    camera.eye = {.25, .1, .3};
    camera.target = camera.eye + glm::dvec3(-std::sin(turn), -.5, -std::cos(turn));
    camera.fov_deg = 100;
    camera.near = near;
    const Rgb<double> walls[] = {ink::sky, ink::orange, ink::pale};

    const auto draw = [&](int panel, int width, int height) {
      studio::Canvas canvas(width, height, {width, height}, ink::slate);
      const auto vertices = studio::clip_space(room, camera, double(width) / height);
      int cut = 0, behind = 0;
      for (std::size_t t = 0; t < room.mesh->triangle_count(); ++t) {
        Polygon corners;
        int inside = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const ClipVertex& v = vertices[room.mesh->indices[3 * t + k]];
          corners.emplace_back(v.x, v.y, v.z, v.w);
          inside += v.w - v.z >= 0;
        }
        cut += inside == 1 || inside == 2, behind += inside == 0;
        if (inside == 0 || (panel == 1 && inside < 3)) continue;
        if (panel == 2) corners = clipped(corners);

        std::vector<glm::dvec2> pixels;
        for (const glm::dvec4& c : corners)
          pixels.emplace_back(width * (0.5 + c.x / c.w / 2), height * (0.5 - c.y / c.w / 2));
        const glm::vec3 n = glm::abs(room.mesh->normals[room.mesh->indices[3 * t]]);
        const Rgb<double>& wall = walls[n.x > .5f ? 0 : n.y > .5f ? 2 : 1];
        const Rgb<double> colour = wall * (.45 + .1 * double(t % 4));
        if (panel == 0 && inside > 0 && inside < 3)
          canvas.outline(pixels, wall);
        else if (pixels.size() >= 3)
          canvas.polygon(pixels, colour);
      }
      if (panel == 2) {
        lesson.figure("triangles", std::to_string(room.mesh->triangle_count()));
        lesson.figure("behind the near plane", std::to_string(behind));
        lesson.figure("cut by it", std::to_string(cut));
      }
      return canvas.finish();
    };
    return studio::panels(
        lesson.width(), lesson.height(), 3,
        {"divided by w all the same", "dropped if a corner is behind", "cut at the near plane"},
        draw);
  });
}
