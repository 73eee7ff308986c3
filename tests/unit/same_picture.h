// Whether two pictures are the same to the bit: == would take -0 for 0, and no NaN for itself.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/framebuffer.h"

namespace scanlit::test {

/// The names of the planes of which a bit differs, or which only one picture has; "" where the
/// pictures are the same.
inline std::string planes_that_differ(const Framebuffer& a, const Framebuffer& b) {
  std::string names;
  const auto compare = [&](const auto& p, const auto& q, const char* name) {
    const bool same = std::ranges::equal(std::as_bytes(std::span(p)), std::as_bytes(std::span(q)));
    if (!same) names += names.empty() ? name : std::string(" ") + name;
  };
  compare(a.colour, b.colour, "colour");
  compare(a.rgba8, b.rgba8, "rgba8");
  compare(a.depth, b.depth, "depth");
  compare(a.normal, b.normal, "normal");
  compare(a.object_id, b.object_id, "object_id");
  compare(a.triangle_id, b.triangle_id, "triangle_id");
  compare(a.ambient, b.ambient, "ambient");
  compare(a.diffuse, b.diffuse, "diffuse");
  compare(a.glossy, b.glossy, "glossy");
  compare(a.cost, b.cost, "cost");
  return names;
}

}  // namespace scanlit::test
