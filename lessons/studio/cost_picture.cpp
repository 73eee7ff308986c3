#include "lessons/studio/cost_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "lessons/studio/reflect/sheet_layout.h"
#include "lessons/studio/text.h"
#include "rasterizer/image/image_encoding.h"

namespace scanlit::studio {
namespace {

/// Counts that look alike: few in small steps, many in large ones. Lighter is more; colours are
/// picks from the scale "plasma" of Matplotlib.
struct Band {
  int most;
  const char* label;
  int srgb;
};
constexpr Band bands[] = {{0, "0", 0x181818},      {1, "1", 0x0d0887},      {2, "2", 0x7201a8},
                          {4, "3-4", 0xbd3786},    {8, "5-8", 0xd8576b},    {16, "9-16", 0xed7953},
                          {32, "17-32", 0xfb9f3a}, {64, "33-64", 0xfdca26}, {0, "65+", 0xf0f921}};
constexpr int band_count = int(std::size(bands));

Rgb<double> colour_of(const Band& band) {
  const auto channel = [&](int shift) {
    return linear_from_srgb((band.srgb >> shift & 255) / 255.0);
  };
  return {channel(16), channel(8), channel(0)};
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
      int band = 0;
      while (band < band_count - 1 && count > float(bands[band].most)) ++band;
      fill(picture, x_begin + x, 2 * layout.line + y, x_begin + x + 1, 2 * layout.line + y + 1,
           colour_of(bands[band]));
    }
}

void draw_scale(const Layout& layout, int x_begin, const std::optional<Font>& font,
                Framebuffer& picture) {
  const int top = 2 * layout.line + layout.height + layout.line / 3;
  for (int i = 0; i < band_count; ++i) {
    const auto x = [&](int k) { return x_begin + layout.width * k / band_count; };
    fill(picture, x(i), top, x(i + 1) - 1, top + layout.line / 2, colour_of(bands[i]));
    if (font)
      font->draw(picture, (x(i) + x(i + 1)) / 2, top + layout.line / 2 + layout.text,
                 bands[i].label, std::max(8, layout.text * 2 / 3), Align::centre, ink);
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
