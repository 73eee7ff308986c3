#include "models/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "models/registry.h"
#include "rasterizer/error.h"

namespace scanlit::models {

namespace {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

double parse_number(const std::string& where, std::string_view text, const ParameterInfo& p) {
  const std::string wanted =
      "'" + p.key + "' wants a number from " + number_text(p.min) + " to " + number_text(p.max);
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw Error(where, wanted + ", not '" + std::string(text) + "'");
  if (value < p.min || value > p.max) throw Error(where, wanted + ", not " + std::string(text));
  return value;
}

Rgb<double> parse_colour(const std::string& where, std::string_view text, const ParameterInfo& p) {
  const auto channels = split_outside_parentheses(text, '/');
  if (channels.size() == 1) return Rgb<double>(parse_number(where, text, p));
  if (channels.size() != 3)
    throw Error(where,
                "'" + p.key + "' wants one number or r/g/b, not '" + std::string(text) + "'");
  return {parse_number(where, channels[0], p), parse_number(where, channels[1], p),
          parse_number(where, channels[2], p)};
}

Vec3<double> parse_direction(const std::string& where, std::string_view text,
                             const ParameterInfo& p) {
  const auto parts = split_outside_parentheses(text, '/');
  if (parts.size() != 3)
    throw Error(where, "'" + p.key + "' wants a direction x/y/z, not '" + std::string(text) + "'");
  const Vec3<double> d{parse_number(where, parts[0], p), parse_number(where, parts[1], p),
                       parse_number(where, parts[2], p)};
  const double length = std::sqrt(dot(d, d));
  if (length == 0) throw Error(where, "'" + p.key + "' wants a direction, and 0/0/0 is none");
  return d * (1 / length);
}

std::string parse_choice(const std::string& where, std::string_view text, const ParameterInfo& p) {
  const std::string word(text);
  if (std::find(p.choices.begin(), p.choices.end(), word) == p.choices.end())
    throw Error(where, "'" + p.key + "' cannot be '" + word + "'" + did_you_mean(word, p.choices));
  return word;
}

std::string parse_file(const Context& context, std::string_view text, const ParameterInfo& p) {
  if (text.empty()) throw Error(context.where, "'" + p.key + "' wants the name of a file");
  return (context.folder / std::string(without_parentheses(text))).string();
}

Value parse_value(const Context& context, std::string_view text, const ParameterInfo& p) {
  if (p.kind != ParameterKind::file && is_input(text)) {
    if (!p.varies)
      throw Error(context.where, "'" + p.key + "' cannot vary; it wants one value, not '" +
                                     std::string(text) + "'");
    return make_input(text, context);
  }
  const std::string& where = context.where;
  switch (p.kind) {
    case ParameterKind::number:
      if (text.find('/') != text.npos)
        throw Error(where, "'" + p.key + "' wants one number, not '" + std::string(text) + "'");
      return parse_number(where, text, p);
    case ParameterKind::colour: return parse_colour(where, text, p);
    case ParameterKind::direction: return parse_direction(where, text, p);
    case ParameterKind::choice: return parse_choice(where, text, p);
    case ParameterKind::file: return parse_file(context, text, p);
    case ParameterKind::model: return make(without_parentheses(text), context).model;
    case ParameterKind::group: return std::string(text);
  }
  return p.initial;
}

/// Whether the choice that `only_with` names has been made, and in words what it wants.
bool has_meaning(const ParameterInfo& p, const Values& values) {
  if (p.only_with.empty()) return true;
  const auto equals = p.only_with.find('=');
  const std::string& word =
      std::get<std::string>(value_of(values, std::string_view(p.only_with).substr(0, equals)));
  const std::string_view allowed_words = std::string_view(p.only_with).substr(equals + 1);
  for (const auto allowed : split_outside_parentheses(allowed_words, '|'))
    if (allowed == word) return true;
  return false;
}

void refuse_meaningless(const std::string& where, const ParameterInfo& p, const Values& values) {
  if (has_meaning(p, values)) return;
  const std::string choice = p.only_with.substr(0, p.only_with.find('='));
  throw Error(where, "'" + p.key + "' has a meaning only with " + p.only_with + ", and " + choice +
                         " is " + std::get<std::string>(value_of(values, choice)));
}

bool is_missing(const ParameterInfo& p) {
  const bool by_name = p.kind == ParameterKind::file || p.kind == ParameterKind::model;
  return by_name && std::holds_alternative<std::string>(p.initial) &&
         std::get<std::string>(p.initial).empty();
}

}  // namespace

Values read_values(const Context& context, std::span<const ParameterInfo> parameters,
                   std::span<const Argument> arguments) {
  const std::string& where = context.where;
  Values values;
  std::vector<std::string> keys;
  for (const ParameterInfo& p : parameters)
    values.emplace_back(p.key, p.initial), keys.push_back(p.key);

  std::vector<bool> given(parameters.size());
  for (std::size_t a = 0; a < arguments.size(); ++a) {
    const auto& [written, value] = arguments[a];
    // image(cow.png): the file may stand first without its key.
    const bool file_first = a == 0 && !value.empty() && !parameters.empty() &&
                            parameters.front().kind == ParameterKind::file;
    const std::string& key = written.empty() && file_first ? keys.front() : written;
    if (key.empty()) throw Error(where, "expected key=value, not '" + value + "'");
    const auto index = std::size_t(std::find(keys.begin(), keys.end(), key) - keys.begin());
    if (index == keys.size())
      throw Error(where, "unknown parameter '" + key + "'" + did_you_mean(key, keys));
    if (given[index]) throw Error(where, "'" + key + "' is given twice");
    given[index] = true;
    values[index].second = parse_value(context, value, parameters[index]);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (given[i]) refuse_meaningless(where, parameters[i], values);
    if (!given[i] && is_missing(parameters[i]))
      throw Error(where, "'" + keys[i] + "' must be given: " + parameters[i].meaning);
  }
  return values;
}

const Value& value_of(const Values& values, std::string_view key) {
  return std::find_if(values.begin(), values.end(), [&](auto& v) { return v.first == key; })
      ->second;
}

Rgb<double> colour_of(const Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number ? Rgb<double>(*number) : std::get<Rgb<double>>(value);
}

}  // namespace scanlit::models
