#include "lessons/studio/drawing/panels.h"

#include <algorithm>
#include <cmath>

#include "lessons/studio/reflect/sheet_layout.h"

namespace scanlit::studio {

Framebuffer panels(int width, int height, int columns, const std::vector<std::string>& captions,
                   const std::function<Framebuffer(int panel, int width, int height)>& draw,
                   const Rgb<double>& paper, int sheet_height) {
  const int count = int(captions.size()), rows = (count + columns - 1) / columns;
  const WordSizes sizes = word_sizes(sheet_height > 0 ? sheet_height : height);
  const int size = sizes.largest, gap = std::max(2, size / 2);
  const auto caption_height = [&](int row) {
    const auto first = captions.begin() + row * columns;
    const auto end = captions.begin() + std::min(count, (row + 1) * columns);
    return std::all_of(first, end, std::mem_fn(&std::string::empty)) ? gap : size * 17 / 10;
  };
  int captions_height = 0;
  for (int row = 0; row < rows; ++row) captions_height += caption_height(row);
  const int panel_width = std::max(1, (width - gap * (columns + 1)) / columns);
  const int panel_height = std::max(1, (height - gap - captions_height) / rows);
  const bool dark = paper.g < 0.2;

  Framebuffer sheet = blank_picture(width, height, paper);
  for (int i = 0, y = gap; i < count; ++i) {
    if (i > 0 && i % columns == 0) y += panel_height + caption_height(i / columns - 1);
    // The last row may be shorter than the others, and stands in the middle.
    const int in_row = std::min(columns, count - i / columns * columns);
    const int row_width = in_row * (panel_width + gap) - gap;
    const int x = (width - row_width) / 2 + i % columns * (panel_width + gap);
    paste(draw(i, panel_width, panel_height), sheet, x, y);
    write_words(sheet, x + panel_width / 2.0, y + panel_height + size * 1.15,
                captions[std::size_t(i)], Align::centre, dark ? ink::white : ink::black,
                panel_width + gap, sizes);
  }
  return sheet;
}

Framebuffer stacked(const Framebuffer& top, const Framebuffer& bottom) {
  Framebuffer sheet(std::max(top.width, bottom.width), top.height + bottom.height);
  paste(top, sheet, 0, 0);
  paste(bottom, sheet, 0, top.height);
  return sheet;
}

Framebuffer reduced(const Framebuffer& picture, int n) {
  Framebuffer result(picture.width / n, picture.height / n);
  const float share = 1 / float(n * n);
  for (int y = 0; y < result.height * n; ++y)
    for (int x = 0; x < result.width * n; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        result.colour[4 * (std::size_t(y / n) * result.width + x / n) + c] +=
            share * picture.colour[4 * (std::size_t(y) * picture.width + x) + c];
  return result;
}

Framebuffer magnified(const Framebuffer& picture, int n) {
  Framebuffer result(picture.width * n, picture.height * n);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        result.colour[4 * (std::size_t(y) * result.width + x) + c] =
            picture.colour[4 * (std::size_t(y / n) * picture.width + x / n) + c];
  return result;
}

Framebuffer difference(const Framebuffer& a, const Framebuffer& b, double times, double& largest) {
  Framebuffer result(a.width, a.height);
  largest = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) {
    const double apart = std::abs(a.colour[i] - b.colour[i]);
    if (i % 4 < 3) largest = std::max(largest, apart);
    result.colour[i] = i % 4 < 3 ? float(std::min(apart * times, 1.0)) : 1;
  }
  return result;
}

}  // namespace scanlit::studio
