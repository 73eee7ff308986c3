#include "lessons/studio/drawing/landscape.h"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/reflect/ticks.h"
#include "rasterizer/mesh.h"

namespace scanlit::studio {
namespace {

constexpr int cells = 96;                   // a side
constexpr glm::dvec3 size(1.5, 1.25, 0.8);  // of the box around it, in world units
const Rgb<double> line_colour{.25, .25, .26};

/// The landscape in its box: x to the right, z up, y into the picture.
class Plot {
 public:
  Plot(const Landscape& landscape, int width, int height)
      : land_(landscape), width_(width), height_(height) {
    const Camera camera = over_the_corner(double(width) / height);
    clip_ = clip_from_world(camera, double(width) / height);
    picture_ = photograph(surface(), camera, width, height);
  }

  Framebuffer take_picture() { return std::move(picture_); }

  glm::dvec3 place(double x, double y, double z) const {
    return {size.x * (land_.x.place(x) - .5), size.z * (land_.z.place(z) - .5),
            size.y * (.5 - land_.y.place(y))};
  }
  glm::dvec3 on_surface(double x, double y) const { return place(x, y, land_.height(x, y)); }
  glm::dvec2 pixel(const glm::dvec3& world) const {
    const glm::dvec4 p = clip_ * glm::dvec4(world, 1);
    return {(p.x / p.w + 1) / 2 * width_, (1 - p.y / p.w) / 2 * height_};
  }

 private:
  /// With the whole box in the picture, and room for ticks and titles around it.
  static Camera over_the_corner(double aspect) {
    Object box = make_object("cube", "lambert");  // side 2
    box.world_from_object = glm::mat4(glm::scale(glm::translate(glm::dmat4(1), {.06, -.08, 0}),
                                                 {size.x / 2 + .2, size.z / 2 + .14, size.y / 2}));
    Scene scene;
    scene.objects = {box};
    Camera camera = fitted({.eye = {.45, 1.3, 1.6}, .fov_deg = 24}, scene, aspect);
    camera.near /= 2, camera.far *= 2;  // a height may lie beyond its axis
    return camera;
  }

  Scene surface() const {
    std::vector<glm::vec3> positions, colours;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i <= cells; ++i)
      for (std::uint32_t j = 0; j <= cells; ++j) {
        const double x = std::lerp(land_.x.low, land_.x.high, double(i) / cells);
        const double y = std::lerp(land_.y.low, land_.y.high, double(j) / cells);
        const Rgb<double> colour = land_.colour(x, y);
        positions.emplace_back(on_surface(x, y));
        colours.emplace_back(colour.r, colour.g, colour.b);
        const std::uint32_t k = i * (cells + 1) + j;
        if (i < cells && j < cells) faces.push_back({k, k + cells + 1, k + cells + 2, k + 1});
      }
    Object object = make_object("plane", "lambert:kd=vertex-colour");
    Mesh mesh = make_mesh("landscape", positions, faces);
    mesh.colours = colours;
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
    object.material.ambient_share = .55;
    Scene scene;
    scene.objects = {object};
    scene.lights = {far_light({-.6, 1, .5}, .5)};
    scene.background = ink::paper;
    return scene;
  }

  const Landscape& land_;
  int width_, height_;
  glm::dmat4 clip_;
  Framebuffer picture_;
};

std::vector<double> ticks(const ChartAxis& axis, int about = 4) {
  const double step = round_ticks(axis.high - axis.low, about)[1];
  std::vector<double> result;
  for (double k = std::ceil(axis.low / step - 1e-9) + 0.0; k * step <= axis.high + 1e-9 * step; ++k)
    result.push_back(k * step);
  return result;
}

}  // namespace

Framebuffer draw(const Landscape& land, int width, int height, int sheet_height) {
  Plot plot(land, width, height);
  Canvas canvas(plot.take_picture());
  canvas.letter_for(sheet_height);
  const double word = word_sizes(sheet_height).largest;
  const auto across = [&](const auto& point, double low, double high) {  // a line on the surface
    std::vector<glm::dvec2> line;
    for (int i = 0; i <= cells; ++i)
      line.push_back(plot.pixel(point(std::lerp(low, high, i / double(cells)))));
    canvas.polyline(line, line_colour, 3);
  };
  for (const double x : ticks(land.x)) {
    across([&](double y) { return plot.on_surface(x, y); }, land.y.low, land.y.high);
    const glm::dvec2 at = plot.pixel(plot.place(x, land.y.low, land.z.low));
    canvas.words(at + glm::dvec2(0, 1.2 * word), tick_text(x), ink::black, Align::centre);
  }
  for (const double y : ticks(land.y, 3)) {
    across([&](double x) { return plot.on_surface(x, y); }, land.x.low, land.x.high);
    if (y == land.y.low) continue;  // the tick would stand on that of x
    const glm::dvec2 at = plot.pixel(plot.place(land.x.high, y, land.z.low));
    canvas.words(at + glm::dvec2(.5 * word, .6 * word), tick_text(y), ink::black);
  }
  for (const double z : ticks(land.z, 2)) {
    const glm::dvec2 at = plot.pixel(plot.place(land.x.low, land.y.low, z));
    canvas.dot(at, ink::black, 5);
    canvas.words(at + glm::dvec2(-.5 * word, .35 * word), tick_text(z), ink::black, Align::right);
  }
  const auto edge = [&](const glm::dvec3& a, const glm::dvec3& b) {
    canvas.line(plot.pixel(a), plot.pixel(b), ink::black, 4);
  };
  const glm::dvec3 corner = plot.place(land.x.low, land.y.low, land.z.low),
                   right = plot.place(land.x.high, land.y.low, land.z.low);
  edge(corner, right);
  edge(right, plot.place(land.x.high, land.y.high, land.z.low));
  edge(corner, plot.place(land.x.low, land.y.low, land.z.high));
  const glm::dvec2 title = plot.pixel(corner * .6 + right * .4);
  canvas.words(title + glm::dvec2(0, 2.6 * word), land.x.title, ink::black, Align::centre);
  const glm::dvec3 far_right = plot.place(land.x.high, land.y.high, land.z.low);
  canvas.words(plot.pixel(far_right) + glm::dvec2(.8 * word, -.8 * word), land.y.title, ink::black);
  canvas.words({.5 * word, 1.3 * word}, land.z.title, ink::black);
  return canvas.finish();
}

}  // namespace scanlit::studio
