#include "lessons/studio/drawing/heat.h"

#include "lessons/studio/drawing/canvas.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "rasterizer/image/image_encoding.h"

namespace scanlit::studio {

Rgb<double> HeatScale::colour_of_band(std::size_t band) const {
  constexpr int srgb[most_bands] = {0x181818, 0x0d0887, 0x7201a8, 0xbd3786, 0xd8576b,
                                    0xed7953, 0xfb9f3a, 0xfdca26, 0xf0f921};
  const auto channel = [&](int shift) {
    return linear_from_srgb((srgb[band] >> shift & 255) / 255.0);
  };
  return {channel(16), channel(8), channel(0)};
}

Rgb<double> HeatScale::colour(double value) const {
  std::size_t band = 0;
  while (band + 1 < bands_.size() && value > bands_[band].most) ++band;
  return colour_of_band(band);
}

Framebuffer HeatScale::draw(const std::vector<double>& values, int width, int height) const {
  Framebuffer picture(width, height);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const Rgb<double> c = values[i] < 0 ? ink::slate : colour(values[i]);
    const float rgba[] = {float(c.r), float(c.g), float(c.b), 1};
    std::copy(rgba, rgba + 4, &picture.colour[4 * i]);
  }
  return picture;
}

Framebuffer HeatScale::legend(const std::string& title, int width, int height,
                              int sheet_height) const {
  Framebuffer picture = blank_picture(width, height, ink::slate);
  const WordSizes sizes = word_sizes(sheet_height);
  const int gap = std::max(2, sizes.largest / 2), count = int(bands_.size());
  const int strip_width = width - 2 * gap, top = sizes.largest * 3 / 2;
  const int bottom = std::max(top + 1, height - sizes.largest * 3 / 2);
  write_words(picture, width / 2.0, sizes.largest, title, Align::centre, ink::white, strip_width,
              sizes);
  for (int i = 0; i < count; ++i) {
    const auto x = [&](int k) { return gap + strip_width * k / count; };
    const std::size_t band = std::size_t(i);
    fill(picture, x(i), top, std::max(x(i) + 1, x(i + 1) - 2), bottom, colour_of_band(band));
    write_words(picture, (x(i) + x(i + 1)) / 2.0, bottom + sizes.largest, bands_[band].label,
                Align::centre, ink::white, strip_width / double(count), sizes);
  }
  return picture;
}

HeatScale count_scale(int bands) {
  std::vector<HeatScale::Band> all = {{0, "0"},      {1, "1"},      {2, "2"},
                                      {4, "3-4"},    {8, "5-8"},    {16, "9-16"},
                                      {32, "17-32"}, {64, "33-64"}, {0, "65+"}};
  all.resize(std::size_t(bands));
  return HeatScale(std::move(all));
}

}  // namespace scanlit::studio
