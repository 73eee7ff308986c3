// Faces that name a vertex more than once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scanlit::detail {

struct FaceRepeats {
  bool any = false;
  std::size_t distinct = 0;         // vertices
  std::vector<std::size_t> copies;  // corners whose vertex an earlier corner names already
};

/// Removes corners that repeat the one before them (the first follows the last) and tells of those
/// that come back later: the bridges by which a polygon with a hole is written as one outline.
template <class Corner, class VertexOf>
FaceRepeats mend_repeats(std::vector<Corner>& corners, VertexOf vertex_of) {
  FaceRepeats result;
  const std::size_t named = corners.size();
  const auto same = [&](const Corner& a, const Corner& b) { return vertex_of(a) == vertex_of(b); };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  while (corners.size() > 1 && same(corners.front(), corners.back())) corners.pop_back();

  std::vector<std::size_t> order(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return vertex_of(corners[i]); });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (same(corners[order[i - 1]], corners[order[i]])) result.copies.push_back(order[i]);

  result.any = corners.size() != named || !result.copies.empty();
  result.distinct = corners.size() - result.copies.size();
  return result;
}

}  // namespace scanlit::detail
