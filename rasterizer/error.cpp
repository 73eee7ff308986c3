#include "rasterizer/error.h"

#include <algorithm>

namespace scanlit {
namespace {

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b (Damerau 1964;
/// optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  // distance[i][j] is that of a's first i letters to b's first j.
  std::vector distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& d = distance[i][j];
      d = std::max(i, j);
      if (i == 0 || j == 0) continue;
      d = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                    distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d = std::min(d, distance[i - 2][j - 2] + 1);
    }
  }
  return distance.back().back();
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  if (candidates.empty()) return "";
  // A file's worth of text is no slip, and would take its square in time and memory.
  constexpr std::size_t longest = 100;
  const auto distance_to = [&](const std::string& candidate) {
    const std::size_t longer = std::max(word.size(), candidate.size());
    return longer > longest ? longer : edit_distance(word, candidate);
  };
  const std::string& nearest = *std::ranges::min_element(candidates, {}, distance_to);
  // One slip is near enough for the shortest words too, where a third rounds to nothing.
  const std::size_t near_enough = std::max<std::size_t>(1, word.size() / 3);
  if (word.size() > 1 && distance_to(nearest) <= near_enough)
    return "; did you mean '" + nearest + "'?";

  std::string all = "; there are: ";
  for (const std::string& candidate : candidates) {
    if (&candidate != &candidates.front()) all += ", ";
    all += candidate;
  }
  return all;
}

}  // namespace scanlit
