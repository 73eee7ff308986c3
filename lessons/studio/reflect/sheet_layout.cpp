#include "lessons/studio/reflect/sheet_layout.h"

#include <algorithm>

#include "lessons/studio/program.h"

namespace scanlit::studio {

Framebuffer blank_picture(int width, int height, const Rgb<double>& colour) {
  Framebuffer picture(width, height);
  fill(picture, 0, 0, width, height, colour);
  return picture;
}

void paste(const Framebuffer& from, Framebuffer& to, int x, int y) {
  for (int row = std::max(0, -y); row < std::min(from.height, to.height - y); ++row) {
    const int first = std::max(0, -x), last = std::min(from.width, to.width - x);
    if (first >= last) return;
    const auto source = from.colour.begin() + 4 * (std::ptrdiff_t(row) * from.width);
    std::copy(source + 4 * first, source + 4 * last,
              to.colour.begin() + 4 * (std::ptrdiff_t(row + y) * to.width + x + first));
  }
}

void fill(Framebuffer& picture, int x_begin, int y_begin, int x_end, int y_end,
          const Rgb<double>& colour) {
  for (int y = std::max(0, y_begin); y < std::min(y_end, picture.height); ++y)
    for (int x = std::max(0, x_begin); x < std::min(x_end, picture.width); ++x) {
      float* pixel = &picture.colour[4 * (std::size_t(y) * picture.width + x)];
      pixel[0] = float(colour.r), pixel[1] = float(colour.g), pixel[2] = float(colour.b);
      pixel[3] = 1;
    }
}

std::optional<Font> label_font() {
  auto font = Font::find();
  if (!font)
    warn("no font was found, and labels are left out; Debian's package fonts-dejavu-core has one");
  return font;
}

std::vector<std::string> two_lines(const Font& font, const std::string& text, int size,
                                   int max_width) {
  if (font.width(text, size) <= max_width) return {text};
  std::size_t end = 0;
  for (std::size_t i = 1; i < text.size(); ++i)
    if (text[i] == ' ' || text[i - 1] == ',' || text[i - 1] == ':')
      if (font.width(text.substr(0, i), size) <= max_width) end = i;
  if (end == 0) return {font.fitted(text, size, max_width)};
  return {text.substr(0, end), font.fitted(text.substr(end), size, max_width)};
}

}  // namespace scanlit::studio
