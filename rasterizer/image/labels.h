// Lettering on a picture, through OpenImageIO, in a font of the system.
#pragma once

#include <optional>
#include <string>

#include "rasterizer/framebuffer.h"
#include "rasterizer/vec.h"

namespace scanlit {

enum class Align { left, centre, right };

/// A font file. Texts are ASCII; a question mark is drawn for any other character, since
/// OpenImageIO 2.4 draws wrong ones. A system may have none: pictures are then drawn without their
/// labels.
class Font {
 public:
  /// The file that the environment variable SCANLIT_FONT names, or, where it is not set, a plain
  /// sans serif of the system's font folders (Debian: package fonts-dejavu-core). None where there
  /// is none that can be read.
  static std::optional<Font> find();

  /// Of text in this size, in pixels.
  int width(const std::string& text, int size) const;

  /// The text, or as much of its beginning and end as fits into so many pixels, around "...".
  std::string fitted(const std::string& text, int size, int max_width) const;

  /// Draws text with its baseline at y; x is its left end, middle or right end. Linear light. What
  /// reaches beyond the picture is cut off. Where letters are, the picture counts as covered.
  void draw(Framebuffer& picture, int x, int y, const std::string& text, int size, Align align,
            const Rgb<float>& colour) const;

 private:
  explicit Font(std::string file) : file_(std::move(file)) {}
  std::string file_;
};

}  // namespace scanlit
