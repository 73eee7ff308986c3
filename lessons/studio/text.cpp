#include "lessons/studio/text.h"

#include <charconv>
#include <cmath>

#include "lessons/studio/split.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::studio {

const Choices<Shading> shadings{
    {"flat", Shading::flat}, {"gouraud", Shading::gouraud}, {"phong", Shading::phong}};
const Choices<Sides> all_sides{
    {"automatic", Sides::automatic}, {"front", Sides::front}, {"both", Sides::both}};
const Choices<NormalWeight> normal_weights{{"area", NormalWeight::area},
                                           {"angle", NormalWeight::angle}};
const Choices<Encoding> encodings{{"srgb", Encoding::srgb}, {"linear", Encoding::linear}};
const Choices<Projection> projections{{"perspective", Projection::perspective},
                                      {"orthographic", Projection::orthographic}};
const Choices<LightKind> light_kinds{{"directional", LightKind::directional},
                                     {"point", LightKind::point},
                                     {"spot", LightKind::spot}};
const Choices<TangentField> tangent_fields{{"around", TangentField::around},
                                           {"along", TangentField::along},
                                           {"texcoord", TangentField::texcoord}};
const Choices<Tangents> brushes{{"around x", {.field = TangentField::around, .axis = {1, 0, 0}}},
                                {"around y", {.field = TangentField::around, .axis = {0, 1, 0}}},
                                {"around z", {.field = TangentField::around, .axis = {0, 0, 1}}},
                                {"along x", {.field = TangentField::along, .axis = {1, 0, 0}}},
                                {"along y", {.field = TangentField::along, .axis = {0, 1, 0}}},
                                {"along z", {.field = TangentField::along, .axis = {0, 0, 1}}},
                                {"texcoord", {.field = TangentField::texcoord}}};

namespace {

/// Whether all of `text` is a number of type T.
template <class T>
bool reads_as(std::string_view text, T& value) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size();
}

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

}  // namespace

std::string text_of(double value) {
  char buffer[64];
  const double size = std::abs(value);  // 100000, not 1e+05; but 1e+12
  const auto format = size == 0 || (size >= 1e-4 && size < 1e9) ? std::chars_format::fixed
                                                                : std::chars_format::general;
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr};
}

std::string text_of(const Rgb<double>& colour) {
  if (colour == Rgb<double>(colour.r)) return text_of(colour.r);
  return text_of(colour.r) + '/' + text_of(colour.g) + '/' + text_of(colour.b);
}

std::string fixed(double value, int decimals) {
  char buffer[400];  // the largest double has 309 digits
  return {
      buffer,
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr};
}

std::string grouped(std::int64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

double in_range(const std::string& where, double value, const Range& range) {
  if (!std::isfinite(value)) throw Error(where, text_of(value) + " is not a finite number");
  if (value < range.min || value > range.max)
    throw Error(where, text_of(value) + " is out of range; allowed is " + text_of(range.min) +
                           " to " + text_of(range.max));
  return value;
}

double parse_number(const std::string& where, std::string_view text, const Range& range) {
  double value;
  if (!reads_as(text, value)) throw Error(where, quoted(text) + " is not a number");
  return in_range(where, value, range);
}

int parse_integer(const std::string& where, std::string_view text, const Range& range) {
  int value;
  if (!reads_as(text, value)) throw Error(where, quoted(text) + " is not a whole number");
  in_range(where, value, range);
  return value;
}

glm::dvec3 parse_vector(const std::string& where, std::string_view text) {
  const auto parts = split(text, ',');
  if (parts.size() != 3)
    throw Error(where, quoted(text) + " is not a vector; three numbers are, as in 0,1.5,-2");
  glm::dvec3 vector;
  for (int i = 0; i < 3; ++i) vector[i] = parse_number(where, parts[i], any_coordinate);
  return vector;
}

Rgb<double> parse_colour(const std::string& where, std::string_view text, const Range& range) {
  // A model's specification separates channels by '/', vectors of coordinates by ',': both are
  // read.
  const auto parts = split(text, text.find('/') == text.npos ? ',' : '/');
  if (parts.size() == 1) return Rgb<double>(parse_number(where, text, range));
  if (parts.size() != 3)
    throw Error(where,
                quoted(text) + " is not a colour; three numbers are, as in .8,.2,.1, or one");
  return {parse_number(where, parts[0], range), parse_number(where, parts[1], range),
          parse_number(where, parts[2], range)};
}

std::pair<int, int> parse_size(const std::string& where, std::string_view text) {
  const auto parts = split(text, 'x');
  int width, height;
  if (parts.size() != 2 || !reads_as(parts[0], width) || !reads_as(parts[1], height))
    throw Error(where, quoted(text) + " is not a size; a width and a height are, as in 960x720");
  const Range side{1, max_framebuffer_size};
  in_range(where, width, side);
  in_range(where, height, side);
  return {width, height};
}

int check_samples(const std::string& where, int samples) {
  if (samples != 1 && samples != 4 && samples != 8 && samples != 16)
    throw Error(where, std::to_string(samples) + " samples a pixel; there can be 1, 4, 8 or 16");
  return samples;
}

}  // namespace scanlit::studio
