#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "rasterizer/image/openimageio.h"

namespace scanlit {

std::optional<int> openimageio::text_width(const std::string& font_file, const std::string& text,
                                           int size) {
  const OIIO::ROI roi = OIIO::ImageBufAlgo::text_size(text, size, font_file);
  return roi.defined() ? std::optional(roi.width()) : std::nullopt;
}

void openimageio::draw_text(Framebuffer& picture, const std::string& font_file, int x, int y,
                            const std::string& text, int size, Align align,
                            const Rgb<float>& colour) {
  using OIIO::ImageBufAlgo::TextAlignX;
  const TextAlignX align_x = align == Align::left     ? TextAlignX::Left
                             : align == Align::centre ? TextAlignX::Center
                                                      : TextAlignX::Right;
  // OpenImageIO 2.4 aborts where no letter reaches the picture.
  const OIIO::ROI letters = OIIO::ImageBufAlgo::text_size(text, size, font_file);
  if (!letters.defined()) return;
  const int left = align == Align::left     ? x
                   : align == Align::centre ? x - letters.width() / 2
                                            : x - letters.width();
  if (left >= picture.width || left + letters.width() <= 0 ||
      y + letters.ybegin >= picture.height || y + letters.yend <= 0)
    return;
  const OIIO::ImageSpec spec(picture.width, picture.height, 4, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf pixels(spec, picture.colour.data());
  OIIO::ImageBufAlgo::render_text(pixels, x, y, text, size, font_file,
                                  {colour.r, colour.g, colour.b, 1.0f}, align_x);
}

}  // namespace scanlit
