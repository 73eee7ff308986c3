#include <algorithm>
#include <cmath>
#include <memory>

#include "lessons/studio/reflect/pictures.h"
#include "lessons/studio/reflect/query.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "lessons/studio/text.h"
#include "rasterizer/render.h"
#include "rasterizer/shapes.h"

namespace scanlit::studio {
namespace {

const Rgb<double> background{0.022};
const Rgb<float> ink{0.75f};

Framebuffer draw_sphere(const std::shared_ptr<const Mesh>& sphere, const models::NamedModel& model,
                        double light_deg, int side) {
  Object object;
  object.mesh = sphere;
  object.material.model = model.model;
  object.material.ka = Rgb<double>(0.0);

  Light light;
  const double angle = radians_of(light_deg), aside = std::sin(angle) / std::sqrt(2.0);
  light.direction = {-aside, aside, std::cos(angle)};

  Scene scene;
  scene.objects = {object};
  scene.lights = {light};
  scene.background = background;

  Camera camera;
  camera.eye = {0, 0, 4};
  camera.projection = Projection::orthographic;
  camera.height = 2.14;
  camera.far = 8;

  RenderSettings settings;
  settings.samples = 16;
  Framebuffer framebuffer(side, side);
  render(scene, camera, settings, framebuffer);
  return framebuffer;
}

}  // namespace

Framebuffer draw_spheres(const PictureRequest& request) {
  const int side = request.cell, size = std::clamp(side / 16, 11, 24), line = size * 4 / 3;
  const int columns = int(request.light_angles_deg.size()), rows = int(request.models.size());
  const int head = 2 * line, below = 2 * line + line / 2, gap = side / 16;
  const int row_height = side + below;
  validate_size(columns * side + 2 * gap, head + rows * row_height);
  Framebuffer picture =
      blank_picture(columns * side + 2 * gap, head + rows * row_height, background);
  const auto font = label_font();
  const auto sphere = std::make_shared<const Mesh>(make_shape("sphere:128"));

  for (int column = 0; column < columns; ++column) {
    const double light_deg = request.light_angles_deg[std::size_t(column)];
    const int x = gap + column * side;
    if (font)
      font->draw(picture, x + side / 2, head - line / 2, "light at " + text_of(light_deg) + " deg",
                 size, Align::centre, ink);
    for (int row = 0; row < rows; ++row)
      paste(draw_sphere(sphere, request.models[std::size_t(row)], light_deg, side), picture, x,
            head + row * row_height);
  }
  for (int row = 0; font && row < rows; ++row) {
    const auto lines = two_lines(*font, request.models[std::size_t(row)].specification, size,
                                 picture.width - 2 * gap);
    for (std::size_t i = 0; i < lines.size(); ++i)
      font->draw(picture, picture.width / 2, head + row * row_height + side + line * int(i + 1),
                 lines[i], size, Align::centre, ink);
  }
  return picture;
}

}  // namespace scanlit::studio
