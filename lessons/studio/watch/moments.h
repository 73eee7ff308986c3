// What an animation of scan conversion shows, frame by frame.
#pragma once

#include "lessons/studio/watch/scan_story.h"

namespace scanlit::studio {

/// Which moment: a triangle's edges before any row (row -1), one of its rows, or, with `triangle`
/// at the end, what is visible (row 0) and its shaded pixels (row 1).
struct Moment {
  std::size_t triangle;
  int row;
};

constexpr std::size_t most_moments = 600;  // that an animation has, but for its end

/// Every row of every triangle, where these are at most most_moments, else every triangle when it
/// is done. Edges and what is visible at the end are held longer, by repetition.
std::vector<Moment> moments_of(const ScanStory& story, double frames_per_second);

}  // namespace scanlit::studio
