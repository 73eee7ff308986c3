// Rows of pixels under many lights, and what is to be seen of them.
#pragma once

#include <cstdint>
#include <vector>

#include "lessons/assignments/A8_less_work/less_work.h"

namespace scanlit::assignments::less_work {

struct Variant {
  bool larger_is_nearer, first_wins;
  explicit Variant(std::uint64_t seed);
};

/// Some curved surfaces, one before the other, drawn in any order.
a8::Row drawn_row(const Variant& variant, std::uint64_t seed);

/// What a light adds.
a8::Colour added(const a8::Row& row, const a8::Pair& pair);

/// Of each pixel the fragment that is seen; -1 where there is none.
std::vector<int> visible(const Variant& variant, const a8::Row& row);

std::vector<a8::Colour> right_pixels(const Variant& variant, const a8::Row& row);

/// How many evaluations are needed: of what is seen; of those, where the light reaches a side that
/// faces it; of those, without the weakest lights whose bounds sum up to the tolerance.
struct Work {
  int visible = 0, lit = 0, bounded = 0;
};
Work work(const Variant& variant, const a8::Row& row);

}  // namespace scanlit::assignments::less_work
