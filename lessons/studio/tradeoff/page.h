// What `scanlit tradeoff` writes.
#pragma once

#include <string>
#include <vector>

#include "lessons/studio/tradeoff/axes.h"

namespace scanlit::studio {

/// One HTML page that needs no other file: the answers, the plots, and the picture behind each
/// point, which a click on the point leads to and which is shown where the pointer rests on it.
std::string tradeoff_page(const std::vector<AxisResult>& axes);

/// All figures, with the machine's name: what the page shows, and what it has no room for.
std::string tradeoff_json(const std::vector<AxisResult>& axes);

/// "AMD EPYC 9754, AVX-512, 16 lanes": of the processor that this runs on.
std::string machine();

}  // namespace scanlit::studio
