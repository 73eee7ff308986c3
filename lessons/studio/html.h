// What pages are made of that hold text of others, and pictures within themselves.
#pragma once

#include <string>
#include <string_view>

#include "rasterizer/image.h"

namespace scanlit::studio {

/// As text between tags or in quoted attributes, whoever wrote it: & < > " ' are written as what
/// they are; control characters other than tab and newline, and bytes that are no UTF-8, become
/// U+FFFD.
std::string escape_html(std::string_view text);

/// A PNG file as a URL that holds it: what stands in an img's src.
std::string png_url(const Framebuffer& framebuffer);

}  // namespace scanlit::studio
