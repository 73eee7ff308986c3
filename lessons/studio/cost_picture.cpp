#include "lessons/studio/cost_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "lessons/studio/drawing/heat.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

const HeatScale& scale() {
  static const HeatScale all = count_scale();
  return all;
}

const Rgb<double> paper(0.0);
const Rgb<float> ink(0.6f);

/// All lengths in pixels.
struct Layout {
  int width, height;  // of the frame
  int text = std::clamp(width / 36, 9, 24);
  int line = 3 * text / 2;
  int margin = text;

  int panel_x(int panel) const { return margin + panel * (width + margin); }
  int full_width() const { return panel_x(2); }
  int full_height() const { return 4 * line + height; }
};

/// One quantity of the plane.
struct Panel {
  std::string name;
  int channel;
};

std::string title_of(const Panel& panel, const Framebuffer& frame) {
  double sum = 0, covered = 0, most = 0;
  for (std::size_t i = 0; i < frame.pixel_count(); ++i) {
    const double count = frame.cost[2 * i + std::size_t(panel.channel)];
    sum += count, most = std::max(most, count), covered += frame.colour[4 * i + 3] > 0;
  }
  if (most == 0) return panel.name + ": none at pixels";
  return panel.name + ": " + fixed(sum / std::max(covered, 1.0), 2) + " a covered pixel, at most " +
         grouped(std::int64_t(most));
}

void draw_panel(const Panel& panel, const Framebuffer& frame, const Layout& layout, int x_begin,
                Framebuffer& picture) {
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const std::size_t pixel = std::size_t(y) * std::size_t(frame.width) + std::size_t(x);
      const float count = frame.cost[2 * pixel + std::size_t(panel.channel)];
      fill(picture, x_begin + x, 2 * layout.line + y, x_begin + x + 1, 2 * layout.line + y + 1,
           scale().colour(count));
    }
}

void draw_scale(const Layout& layout, int x_begin, const std::optional<Font>& font,
                Framebuffer& picture) {
  const int top = 2 * layout.line + layout.height + layout.line / 3;
  const int count = int(scale().bands().size());
  for (int i = 0; i < count; ++i) {
    const auto x = [&](int k) { return x_begin + layout.width * k / count; };
    const std::size_t band = std::size_t(i);
    fill(picture, x(i), top, x(i + 1) - 1, top + layout.line / 2, scale().colour_of_band(band));
    if (font)
      font->draw(picture, (x(i) + x(i + 1)) / 2, top + layout.line / 2 + layout.text,
                 scale().bands()[band].label, std::max(8, layout.text * 2 / 3), Align::centre, ink);
  }
}

}  // namespace

std::filesystem::path cost_file(const std::filesystem::path& picture) {
  return picture.parent_path() / (picture.stem().string() + "-cost.png");
}

void check_cost_picture(int width, int height) {
  const Layout layout{width, height};
  validate_size(layout.full_width(), layout.full_height());
}

Framebuffer draw_cost(const Framebuffer& frame, int samples) {
  const Layout layout{frame.width, frame.height};
  const std::string sampled = samples == 1 ? "" : ", " + std::to_string(samples) + " samples";
  const Panel panels[] = {{"depth tests" + sampled, 0}, {"model evaluations", 1}};
  Framebuffer picture = blank_picture(layout.full_width(), layout.full_height(), paper);
  const auto font = label_font();
  for (int i = 0; i < 2; ++i) {
    const int x = layout.panel_x(i);
    draw_panel(panels[i], frame, layout, x, picture);
    draw_scale(layout, x, font, picture);
    if (font)
      font->draw(picture, x, layout.line + layout.text / 3,
                 font->fitted(title_of(panels[i], frame), layout.text, layout.width), layout.text,
                 Align::left, ink);
  }
  return picture;
}

}  // namespace scanlit::studio
