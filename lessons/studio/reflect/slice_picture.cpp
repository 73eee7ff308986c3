#include <algorithm>
#include <cmath>

#include "lessons/studio/reflect/pictures.h"
#include "lessons/studio/reflect/query.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

const Rgb<double> paper{1.0}, frame{0.25};
const Rgb<float> ink{0.0f};

/// pi f_r where the half vector is theta_h from the normal and the light theta_d from the half
/// vector, in the plane across (phi_d = 90 degrees): both directions then are equally far from the
/// normal, cos theta = cos theta_h cos theta_d, and none is ever below the horizon.
Rgb<double> at(const ReflectionModel& model, double theta_h, double theta_d) {
  const Vec3<double> h{std::sin(theta_h), 0, std::cos(theta_h)}, across{0, 1, 0};
  const Vec3<double> l = h * std::cos(theta_d) + across * std::sin(theta_d);
  const Vec3<double> v = h * std::cos(theta_d) - across * std::sin(theta_d);
  return reflected(model, l, v) * (1 / l.z);
}

Framebuffer draw_slice(const ReflectionModel& model, int side) {
  constexpr int grid = 3;  // queries a pixel and axis: a sharp lobe is narrower than a pixel
  Framebuffer slice(side, side);
  const double step = std::numbers::pi / 2 / (side * grid);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      Rgb<double> sum;
      for (int j = 0; j < grid; ++j)
        for (int i = 0; i < grid; ++i)
          sum = sum + at(model, (x * grid + i + 0.5) * step, ((side - y) * grid - j - 0.5) * step);
      fill(slice, x, y, x + 1, y + 1, sum * (1.0 / (grid * grid)));
    }
  return slice;
}

/// "theta" with a smaller, lower letter behind it, and more text; x is the left end.
void draw_angle_name(const Font& font, Framebuffer& picture, int x, int y, int size,
                     const std::string& letter, const std::string& more) {
  font.draw(picture, x, y, "theta", size, Align::left, ink);
  x += font.width("theta", size) + 1;
  font.draw(picture, x, y + size / 4, letter, size * 3 / 4, Align::left, ink);
  x += font.width(letter, size * 3 / 4) + size / 2;
  font.draw(picture, x, y, more, size, Align::left, ink);
}

void draw_axes(const Font& font, Framebuffer& picture, int left, int top, int side, int size) {
  const int bottom = top + side, tick = size / 3;
  for (int deg = 0; deg <= 90; deg += 30) {
    const int x = left + side * deg / 90, y = bottom - side * deg / 90;
    fill(picture, x, bottom, x + 1, bottom + tick, frame);
    fill(picture, left - tick, y, left, y + 1, frame);
    const std::string label = std::to_string(deg);
    font.draw(picture, x, bottom + tick + size * 5 / 4, label, size, Align::centre, ink);
    font.draw(picture, left - tick - size / 3, y + size / 3, label, size, Align::right, ink);
  }
  draw_angle_name(font, picture, left, bottom + tick + size * 11 / 4, size, "h",
                  "(half vector), degrees");
  draw_angle_name(font, picture, left - 2 * size, top - size, size, "d", "(difference), degrees");
}

}  // namespace

Framebuffer draw_slices(const PictureRequest& request) {
  const int side = request.cell, size = std::clamp(side / 18, 11, 26);
  const int left = 4 * size, right = 2 * size, top = 6 * size, below = 4 * size;
  const int count = int(request.models.size()), width = left + side + right;
  validate_size(count * width, top + side + below);
  Framebuffer picture = blank_picture(count * width, top + side + below, paper);
  const auto font = label_font();
  for (int i = 0; i < count; ++i) {
    const models::NamedModel& named = request.models[std::size_t(i)];
    const int x = i * width + left;
    fill(picture, x - 1, top - 1, x + side + 1, top + side + 1, frame);
    paste(draw_slice(*named.model, side), picture, x, top);
    if (!font) continue;
    draw_axes(*font, picture, x, top, side, size);
    const auto lines = two_lines(*font, named.specification, size, width - size);
    for (std::size_t k = 0; k < lines.size(); ++k)
      font->draw(picture, i * width + width / 2, size * 3 / 2 + int(k) * size * 4 / 3, lines[k],
                 size, Align::centre, ink);
  }
  return picture;
}

}  // namespace scanlit::studio
