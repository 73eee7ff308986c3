// Pictures side by side with lettering: what contact sheets and rows of spheres are made of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rasterizer/framebuffer.h"
#include "rasterizer/image/labels.h"

namespace scanlit::studio {

/// A picture of one colour (linear light), covered everywhere.
Framebuffer blank_picture(int width, int height, const Rgb<double>& colour);

/// Copies `from` with its top left corner at (x, y); what reaches beyond `to` is left out.
void paste(const Framebuffer& from, Framebuffer& to, int x, int y);

void fill(Framebuffer& picture, int x_begin, int y_begin, int x_end, int y_end,
          const Rgb<double>& colour);

/// The font for a picture's labels; where there is none, says once that they are left out.
std::optional<Font> label_font();

/// At most two lines that are no wider than max_width, broken after a comma or colon or at a blank.
std::vector<std::string> two_lines(const Font& font, const std::string& text, int size,
                                   int max_width);

}  // namespace scanlit::studio
