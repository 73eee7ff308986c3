#include "lessons/assignments/judge/model_invariants.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments {

using std::numbers::pi;

Finding check_reciprocity(Examination& e, const Asked& asked, const BrdfScale& f_r) {
  Asked there = asked, back = asked;
  for (Directions& d : back.directions) std::swap(d.l, d.v);
  const Values a = ask_values(e.student, there), b = ask_values(e.student, back);
  const auto [least, most] = std::ranges::minmax(a);
  if (!(most > least)) return Finding::wrong("");
  const auto width = std::size_t(asked.width);
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, a[i] * f_r(there.directions[i / width]));
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Directions &d = there.directions[i / width], &swapped = back.directions[i / width];
    if (agree(a[i] * f_r(d), b[i] * f_r(swapped), largest)) continue;
    return Finding::wrong("It is not reciprocal:\n  " + describe(d) +
                          worded("\n  f_r is %.6g 1/sr, and with L and V exchanged %.6g 1/sr",
                                 a[i] * f_r(d), b[i] * f_r(swapped)));
  }
  return {};
}

Finding check_albedo(Examination& e, const Asked& asked, const BrdfScale& f_r) {
  constexpr int rings = 48, sectors = 48;
  for (const double theta_v : {20., 65.}) {
    Asked all = asked;
    all.directions.clear();
    for (int ring = 0; ring < rings; ++ring)
      for (int sector = 0; sector < sectors; ++sector)
        all.directions.push_back(
            {direction((ring + .5) * 90 / rings, (sector + .5) * 360 / sectors),
             direction(theta_v, 180)});
    const Values got = ask_values(e.student, all);
    double sum = 0, right = 0;  // of the first channel
    for (std::size_t i = 0; i < all.directions.size(); ++i) {
      const Directions& d = all.directions[i];
      const double solid_angle =
          std::sqrt(1 - d.l.z * d.l.z) * (pi / 2 / rings) * (2 * pi / sectors);
      sum += got[i * std::size_t(asked.width)] * f_r(d) * d.l.z * solid_angle;
      right += asked.reference(d)[0] * f_r(d) * d.l.z * solid_angle;
    }
    if (!(std::abs(sum - right) <= .02 * right))
      return Finding::wrong(
          worded("Of white light from all around it reflects %.3g times as much to a viewer at %g "
                 "degrees as arrives; it should be %.3g.",
                 sum, theta_v, right));
  }
  return {};
}

}  // namespace scanlit::assignments
