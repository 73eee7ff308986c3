#include "lessons/studio/frames/sweep.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "lessons/studio/text.h"
#include "models/specification.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

using models::split_outside_parentheses;

std::optional<std::vector<double>> numbers_in(std::string_view text, char separator) {
  std::vector<double> numbers;
  for (const std::string_view part : split_outside_parentheses(text, separator)) {
    double& number = numbers.emplace_back();
    const auto [end, code] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (code != std::errc() || end != part.data() + part.size()) return std::nullopt;
  }
  return numbers;
}

constexpr double largest = std::numeric_limits<double>::max();
constexpr Range any_number{-largest, largest};

char separator_of(std::string_view text) { return text.find('/') == text.npos ? ',' : '/'; }

std::string joined(const std::vector<double>& numbers, char separator) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : std::string(1, separator)) + text_of(number);
  return text;
}

}  // namespace

std::vector<double> Sweep::at(double share) const {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < from.size(); ++i) numbers.push_back(std::lerp(from[i], to[i], share));
  return numbers;
}

std::optional<Sweep> parse_sweep(const std::string& where, std::string_view text) {
  const auto colon = text.find(':');
  if (colon == text.npos) return std::nullopt;
  const char separator = separator_of(text);
  const auto from = numbers_in(text.substr(0, colon), separator);
  const auto to = numbers_in(text.substr(colon + 1), separator);
  if (!from || !to) return std::nullopt;
  for (const auto* side : {&*from, &*to})
    for (const double number : *side) in_range(where, number, any_number);
  if (from->size() != to->size())
    throw Error(where, "'" + std::string(text) + "' goes from " + std::to_string(from->size()) +
                           " to " + std::to_string(to->size()) +
                           " numbers; as many are needed on either side");
  return Sweep{*from, *to};
}

std::string text_at(const std::string& where, const std::string& text, double share) {
  const auto value_at = [&](std::string_view value) {
    const auto sweep = parse_sweep(where, value);
    return sweep ? joined(sweep->at(share), separator_of(value)) : std::string(value);
  };
  if (parse_sweep(where, text)) return value_at(text);
  std::string result;
  std::size_t begin = 0;
  for (std::size_t equals; (equals = text.find('=', begin)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(",()=", equals + 1), text.size());
    result += text.substr(begin, equals + 1 - begin);
    result += value_at(std::string_view(text).substr(equals + 1, end - equals - 1));
    begin = end;
  }
  return result + text.substr(begin);
}

PathSweep parse_path_sweep(const std::string& text) {
  const std::string where = "--sweep";
  const auto equals = text.find('=');
  if (equals != text.npos && equals > 0)
    if (const auto sweep = parse_sweep(where, std::string_view(text).substr(equals + 1)))
      return {text.substr(0, equals), *sweep};
  throw Error(where, "'" + text + "' is no PATH=FROM:TO, as in light.0.intensity=0:2");
}

}  // namespace scanlit::studio
