// Several pictures on one sheet, each with its caption.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/studio/drawing/canvas.h"

namespace scanlit::studio {

/// A sheet of so many columns, with a caption under each panel. `draw` is called for each caption
/// in turn, with the panel's number and its size in pixels. Words as for a picture of sheet_height
/// pixels; 0: of this height.
Framebuffer panels(int width, int height, int columns, const std::vector<std::string>& captions,
                   const std::function<Framebuffer(int panel, int width, int height)>& draw,
                   const Rgb<double>& paper = ink::slate, int sheet_height = 0);

/// One above the other.
Framebuffer stacked(const Framebuffer& top, const Framebuffer& bottom);

/// Every block of n x n pixels becomes one, their mean: antialiasing for what is drawn pixel by
/// pixel. Width and height have to be multiples of n.
Framebuffer reduced(const Framebuffer& picture, int n);
/// Every pixel becomes n x n: what is drawn in pixels, to be looked at.
Framebuffer magnified(const Framebuffer& picture, int n);

/// How far each channel of two pictures of one size is apart, so many times as bright; and how far
/// at most.
Framebuffer difference(const Framebuffer& a, const Framebuffer& b, double times, double& largest);

}  // namespace scanlit::studio
