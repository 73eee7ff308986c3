#include "lessons/studio/drawing/chart.h"

#include <algorithm>
#include <cmath>

#include "lessons/studio/reflect/ticks.h"

namespace scanlit::studio {
namespace {

/// About so many.
std::vector<double> ticks(const ChartAxis& axis, int count) {
  std::vector<double> result;
  if (axis.logarithmic) {
    for (int exponent = int(std::ceil(std::log10(axis.low) - 1e-9));
         exponent <= std::log10(axis.high) + 1e-9; ++exponent)
      result.push_back(std::pow(10.0, exponent));
    return result;
  }
  const double step = round_ticks(axis.high - axis.low, count)[1];
  // Plus 0, which makes 0 of -0.
  for (double k = std::ceil(axis.low / step - 1e-9) + 0.0; k * step <= axis.high + 1e-9 * step; ++k)
    result.push_back(k * step);
  return result;
}

}  // namespace

double ChartAxis::place(double value) const {
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

Chart::Chart(int width, int height, ChartAxis x, ChartAxis y, int sheet_height)
    : canvas_(width, height, {width, height}), x_(std::move(x)), y_(std::move(y)) {
  WordSizes sizes = word_sizes(sheet_height == 0 ? height : sheet_height);
  if (sheet_height != 0) sizes.largest = sizes.smallest;  // in a panel there is not much room
  const double word = sizes.largest;
  canvas_.letter(sizes);
  low_ = {3.4 * word, height - 2.9 * word};
  high_ = {width - 1.4 * word, 2.2 * word};
  for (const double tick : ticks(x_, std::clamp(int((high_.x - low_.x) / (4 * word)), 1, 5))) {
    line({tick, y_.low}, {tick, y_.high}, ink::pale, 2);
    canvas_.words({at({tick, y_.low}).x, low_.y + 1.2 * word}, tick_text(tick), ink::black,
                  Align::centre);
  }
  for (const double tick : ticks(y_, 5)) {
    line({x_.low, tick}, {x_.high, tick}, ink::pale, 2);
    canvas_.words({low_.x - 0.4 * word, at({x_.low, tick}).y + 0.35 * word}, tick_text(tick),
                  ink::black, Align::right);
  }
  line({x_.low, y_.low}, {x_.high, y_.low}, ink::black, 3);
  line({x_.low, y_.low}, {x_.low, y_.high}, ink::black, 3);
  canvas_.words({high_.x, low_.y + 2.4 * word}, x_.title, ink::black, Align::right);
  canvas_.words({0.5 * word, 1.4 * word}, y_.title, ink::black);
}

glm::dvec2 Chart::at(glm::dvec2 value) const {
  return low_ + (high_ - low_) * glm::dvec2(x_.place(value.x), y_.place(value.y));
}

void Chart::curve(const std::vector<glm::dvec2>& values, const Rgb<double>& colour, double width) {
  std::vector<glm::dvec2> pixels;
  for (const glm::dvec2& value : values) pixels.push_back(at(value));
  canvas_.polyline(pixels, colour, width);
}

void Chart::dot(glm::dvec2 value, const Rgb<double>& colour, double radius) {
  canvas_.dot(at(value), colour, radius);
}

void Chart::line(glm::dvec2 a, glm::dvec2 b, const Rgb<double>& colour, double width) {
  canvas_.line(at(a), at(b), colour, width);
}

void Chart::words(glm::dvec2 value, const std::string& words, const Rgb<double>& colour,
                  Align align) {
  canvas_.words(at(value), words, colour, align);
}

}  // namespace scanlit::studio
