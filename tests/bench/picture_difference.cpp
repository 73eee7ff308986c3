#include "picture_difference.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace scanlit::bench {

bool PictureDifference::same() const {
  return mean <= .5 && share_above_two <= .001 &&
         double(coverage_differs) <= 1e-4 * double(covered[0]);
}

std::string PictureDifference::words() const {
  char text[160];
  std::snprintf(text, sizeof text,
                "mean %.2f, max %d, above 2 steps on %.3f %%, coverage differs on %lld pixels",
                mean, max, 100 * share_above_two, static_cast<long long>(coverage_differs));
  return text;
}

void PictureDifference::take_worse(const PictureDifference& other) {
  if (covered[0] == 0) std::copy_n(other.covered, 2, covered);
  coverage_differs = std::max(coverage_differs, other.coverage_differs);
  max = std::max(max, other.max);
  mean = std::max(mean, other.mean);
  share_above_two = std::max(share_above_two, other.share_above_two);
}

PictureDifference compare(const Picture& a, const Picture& b) {
  PictureDifference result;
  std::int64_t both = 0, above_two = 0, sum = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    const bool in_a = a[i + 3] > 0, in_b = b[i + 3] > 0;
    result.covered[0] += in_a;
    result.covered[1] += in_b;
    result.coverage_differs += in_a != in_b;
    if (!in_a || !in_b) continue;
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int difference = std::abs(int(a[i + c]) - int(b[i + c]));
      largest = std::max(largest, difference);
      sum += difference;
    }
    ++both;
    above_two += largest > 2;
    result.max = std::max(result.max, largest);
  }
  if (both > 0) {
    result.mean = double(sum) / double(3 * both);
    result.share_above_two = double(above_two) / double(both);
  }
  return result;
}

}  // namespace scanlit::bench
