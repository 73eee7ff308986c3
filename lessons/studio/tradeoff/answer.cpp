#include "lessons/studio/tradeoff/answer.h"

#include <algorithm>
#include <cmath>

#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

ShadingCost cost(const Measured& point) {
  return {double(point.triangles), point.ms, point.steps()};
}

/// `share` of the way from a to b, on a logarithmic scale.
double between(double a, double b, double share) { return a * std::pow(b / a, share); }

/// Two digits: more are not known.
std::string rounded(double count) {
  const double unit = std::pow(10, std::floor(std::log10(count)) - 1);
  return grouped(std::int64_t(std::llround(count / unit) * std::llround(std::max(unit, 1.0))));
}

std::string milliseconds(double ms) { return fixed(ms, ms < 10 ? 2 : 1) + " ms"; }

}  // namespace

std::optional<Answer> answer(const AxisResult& axis) {
  std::vector<ShadingCost> gouraud;
  std::optional<ShadingCost> phong;
  for (const Measured& point : axis.points) {
    if (point.series == "Gouraud") gouraud.push_back(cost(point));
    if (point.series == "Phong" && point.is_default) phong = cost(point);
  }
  if (gouraud.empty() || !phong) return {};
  std::ranges::sort(gouraud, {}, &ShadingCost::triangles);
  Answer result{*phong, {}, gouraud.back()};
  for (std::size_t i = 0; i < gouraud.size(); ++i) {
    if (gouraud[i].steps > phong->steps) continue;
    result.gouraud = gouraud[i];
    if (i == 0) return result;
    const ShadingCost &worse = gouraud[i - 1], &better = gouraud[i];
    const double share =
        std::log(phong->steps / worse.steps) / std::log(better.steps / worse.steps);
    result.gouraud = {between(worse.triangles, better.triangles, share),
                      between(worse.ms, better.ms, share), phong->steps};
    return result;
  }
  return result;
}

std::string words(const AxisResult& axis, const Answer& answer) {
  const std::string as_phong = " to be as right as Phong with " +
                               grouped(std::llround(answer.phong.triangles)) + " (" +
                               milliseconds(answer.phong.ms) + ")";
  if (answer.gouraud)
    return axis.name + ": Gouraud needs " + rounded(answer.gouraud->triangles) + " triangles (" +
           milliseconds(answer.gouraud->ms) + ")" + as_phong;
  return axis.name + ": Gouraud needs more than " +
         grouped(std::llround(answer.finest_gouraud.triangles)) + " triangles (" +
         milliseconds(answer.finest_gouraud.ms) + ")" + as_phong;
}

}  // namespace scanlit::studio
