// New idea: light the vertices, by the surface's own normals there, and interpolate their colours.
// Builds on: lesson 10, flat shading; lesson 9, barycentric coordinates.
// Try: --n 5; --n 200; --shape teapot:8: where has the highlight gone?
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/drawing/stages.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/sheet_layout.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// The reflection model, asked once for each vertex.
std::vector<glm::dvec3> vertex_colours(const Scene& scene, glm::dvec3 to_viewer) {
  std::vector<glm::dvec3> colours;
  for (const glm::vec3& normal : scene.objects[0].mesh->normals) {
    const Rgb<double> c = studio::reflected_light(scene, normal, to_viewer);
    colours.emplace_back(c.r, c.g, c.b);
  }
  return colours;
}

/// Between the vertices of a face: I = b1 I1 + b2 I2 + b3 I3, with the barycentric coordinates.
Rgb<double> colour_at(const studio::VisiblePoint& p, const std::vector<glm::dvec3>& colours) {
  const glm::dvec3 c = p.interpolated(colours);
  return {c.x, c.y, c.z};
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Gouraud shading: light at the vertices, colours between them.", 1500, 500);
  std::string shape = "teapot:3";
  double n = 30;
  lesson.knob("--shape", shape, "what is lit");
  lesson.knob("--n", n, {1, 1000}, "exponent of the highlight");

  return lesson.run(argc, argv, [&] {
    const Scene scene = studio::make_stage(
        {studio::make_object(shape, "blinn-phong:kd=.10/.30/.55,ks=.4,n=" + studio::text_of(n))});
    const Mesh& mesh = *scene.objects[0].mesh;
    const auto draw = [&](int panel, int width, int height) {
      Camera camera;
      camera.eye = {1.2, 1.6, 5};
      camera.fov_deg = 20;
      camera.viewer_at_infinity = true;
      camera = studio::fitted(camera, scene, double(width) / height);
      const auto colours = vertex_colours(scene, towards_viewer(camera));

      constexpr int fine = 3;
      Framebuffer image = studio::blank_picture(width * fine, height * fine, ink::slate);
      const auto points =
          studio::visible_points(scene.objects[0], camera, image.width, image.height);
      if (panel == 1) {
        for (const auto& p : points) studio::put(image, p.x, p.y, colour_at(p, colours));
        return studio::reduced(image, fine);
      }
      // The faces that are seen, and their vertices.
      studio::Canvas canvas(width, height, {width, height}, ink::slate);
      const auto clip = studio::clip_space(scene.objects[0], camera, double(width) / height);
      const auto at = [&](std::uint32_t vertex) {
        const ClipVertex& c = clip[vertex];
        return glm::dvec2(width * (.5 + .5 * c.x / c.w), height * (.5 - .5 * c.y / c.w));
      };
      std::vector<bool> seen(mesh.positions.size());
      for (const auto& p : points)
        for (const std::uint32_t k : p.corner)
          if (!seen[k]) seen[k] = true;
      for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        if (seen[a] && seen[b]) canvas.line(at(a), at(b), ink::soft, 2);
      }
      for (std::uint32_t k = 0; k < seen.size(); ++k)
        if (seen[k]) canvas.dot(at(k), {colours[k].x, colours[k].y, colours[k].z}, 10);
      return canvas.finish();
    };
    lesson.figure("vertices", studio::grouped(std::int64_t(mesh.positions.size())));
    lesson.figure("faces", studio::grouped(std::int64_t(mesh.triangle_count())));
    return studio::panels(lesson.width(), lesson.height(), 2,
                          {"lit at the vertices", "interpolated between them"}, draw);
  });
}
