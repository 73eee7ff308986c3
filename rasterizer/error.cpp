#include "rasterizer/error.h"

#include <algorithm>
#include <numeric>

namespace scanlit {
namespace {

/// Levenshtein distance: insertions, deletions and replacements that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  if (candidates.empty()) return "";
  const auto distance_to = [&](const std::string& candidate) {
    return edit_distance(word, candidate);
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
