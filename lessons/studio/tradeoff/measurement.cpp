#include "lessons/studio/tradeoff/measurement.h"

#include <algorithm>
#include <ctime>

#include "rasterizer/reference/flip.h"

namespace scanlit::studio {
namespace {

constexpr int rounds = 3;
constexpr double round_ms = 40;  // for each candidate
constexpr std::size_t least_frames = 2, most_frames = 12;

/// Of this thread, on which all is drawn: what else runs on the machine does not count.
double processor_ms() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

/// The first frame of a round fetches back into the caches what other candidates drove out.
void time_round(const Candidate& candidate, std::vector<double>& times) {
  candidate.draw();
  double sum = 0;
  for (std::size_t i = 0; i < least_frames || (i < most_frames && sum < round_ms); ++i) {
    const double start = processor_ms();
    candidate.draw();
    times.push_back(processor_ms() - start);
    sum += times.back();
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void find_pareto_front(std::vector<Measured>& points) {
  for (Measured& p : points)
    p.pareto = std::ranges::none_of(points, [&](const Measured& q) {
      const bool no_worse = q.ms <= p.ms && q.steps() <= p.steps();
      return no_worse && (q.ms < p.ms || q.steps() < p.steps());
    });
}

}  // namespace

std::vector<Measured> measure(const std::vector<Candidate>& candidates, const ExactPicture& truth,
                              const Progress& progress) {
  const double steps = double(candidates.size() * (rounds + 1));
  double done = 0;
  std::vector<std::vector<double>> times(candidates.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      time_round(candidates[i], times[i]);
      progress(++done / steps);
    }
  std::vector<Measured> result;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& c = candidates[i];
    const ExactPicture picture = c.picture();
    result.push_back({.series = c.series,
                      .label = c.label,
                      .triangles = c.triangles,
                      .is_default = c.is_default,
                      .ms = median(times[i]),
                      .frames = int(times[i].size()),
                      .error = compare(truth, picture, Encoding::srgb, c.silhouette),
                      .flip = mean_flip(truth, picture),
                      .picture = picture});
    progress(++done / steps);
  }
  find_pareto_front(result);
  return result;
}

}  // namespace scanlit::studio
