// Rows of pixels under many lights, and what is to be seen of them.
#pragma once

#include <cstdint>
#include <vector>

#include "lessons/assignments/A8_less_work/less_work.h"

namespace scanlit::assignments::less_work {

struct Variant {
  bool larger_is_nearer, first_wins;
  int inner, outer;  // a light at distance d is seen with share (1 - (d / reach)^inner)^outer
  explicit Variant(std::uint64_t seed);
};

/// With the reflection model that the student's program asks for, another one in each row: who
/// knew it would need to evaluate nothing.
struct JudgedRow : a8::Row {
  double kd = 0, ks = 0, exponent = 0;
  a8::Colour colour{};  // of the surfaces, each channel at most 1
};

/// Some curved surfaces, one before the other, drawn in any order.
JudgedRow drawn_row(const Variant& variant, std::uint64_t seed);

/// What a light adds.
a8::Colour added(const Variant& variant, const JudgedRow& row, const a8::Pair& pair);

/// Of each pixel the fragment that is seen; -1 where there is none.
std::vector<int> visible(const Variant& variant, const JudgedRow& row);

/// What is seen if depth is not looked at: of each pixel the fragment that was drawn last.
std::vector<a8::Colour> painted_pixels(const Variant& variant, const JudgedRow& row);

std::vector<a8::Colour> right_pixels(const Variant& variant, const JudgedRow& row);

/// How many evaluations are needed: of what is seen; of those, where the light reaches a side that
/// faces it; of those, without the weakest lights whose bounds sum up to the tolerance.
struct Work {
  int visible = 0, lit = 0, bounded = 0;
};
Work work(const Variant& variant, const JudgedRow& row);

}  // namespace scanlit::assignments::less_work
