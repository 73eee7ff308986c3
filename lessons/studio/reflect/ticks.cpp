#include "lessons/studio/reflect/ticks.h"

#include <cmath>
#include <cstdio>

namespace scanlit::studio {

std::vector<double> round_ticks(double max, int count) {
  const double rough = max / count, power = std::pow(10, std::floor(std::log10(rough)));
  const auto distance = [&](double factor) { return std::abs(std::log(factor * power / rough)); };
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0})
    if (distance(factor) < distance(step / power)) step = factor * power;
  std::vector<double> ticks{0};
  // A hundredth of a step above the last tick is not worth another.
  while (ticks.back() < max - 0.01 * step) ticks.push_back(step * double(ticks.size()));
  return ticks;
}

std::string tick_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string power_of_ten(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

}  // namespace scanlit::studio
