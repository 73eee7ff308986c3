#include "lessons/studio/tradeoff/label_places.h"

#include <algorithm>
#include <limits>

namespace scanlit::studio {
namespace {

constexpr double letter_width = 0.58;  // of the size, on average, in a plain sans serif

/// Characters of UTF-8 text.
double length(const std::string& text) {
  return double(std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

void LabelPlaces::keep_free(PlotPoint p, double radius) {
  taken_.push_back({p.x - radius, p.y - radius, p.x + radius, p.y + radius});
}

/// In square pixels; what sticks out of the panel counts for more.
double LabelPlaces::covered(const Box& box) const {
  const auto overlap = [&](const Box& b) {
    return std::max(0.0, std::min(box.right, b.right) - std::max(box.left, b.left)) *
           std::max(0.0, std::min(box.bottom, b.bottom) - std::max(box.top, b.top));
  };
  const Box inside{panel_.left, panel_.top, panel_.left + panel_.width, panel_.top + panel_.height};
  const double area = (box.right - box.left) * (box.bottom - box.top);
  double sum = 10 * (area - overlap(inside));
  for (const Box& b : taken_) sum += overlap(b);
  return sum;
}

PlacedLabel LabelPlaces::place(PlotPoint p, const std::string& text, double gap) {
  const double width = letter_width * size_ * length(text);
  PlacedLabel best{};
  Box best_box{};
  double least = std::numeric_limits<double>::infinity();
  for (const double reach : {1.0, 2.2, 3.4})
    for (const auto& [dx, dy] : {std::pair(1.0, 0.0),
                                 {-1.0, 0.0},
                                 {0.0, -1.0},
                                 {0.0, 1.0},
                                 {0.7, -0.9},
                                 {0.7, 0.9},
                                 {-0.7, -0.9},
                                 {-0.7, 0.9}}) {
      const double x = p.x + reach * gap * dx, y = p.y + reach * (gap + size_ / 3) * dy;
      const double left = dx > 0 ? x : dx < 0 ? x - width : x - width / 2;
      const Box box{left, y - size_ / 2, left + width, y + size_ / 2};
      const double cost = covered(box);
      if (!(cost < least)) continue;
      least = cost, best_box = box;
      best = {{x, y + 0.35 * size_}, dx > 0 ? "start" : dx < 0 ? "end" : "middle"};
    }
  taken_.push_back(best_box);
  return best;
}

}  // namespace scanlit::studio
