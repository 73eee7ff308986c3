#include "models/registry.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "models/formula.h"
#include "rasterizer/error.h"

// The registry: including a model's file registers it. A new model is one file and one line here.
#include "models/blinn_phong.h"
#include "models/lambert.h"
#include "models/phong.h"

namespace scanlit::models {

namespace {

// A function's static, because models in other files register before main().
std::vector<Entry>& entries() {
  static std::vector<Entry> all;
  return all;
}

template <class Range, class Name>
std::vector<std::string> names(const Range& range, Name name) {
  std::vector<std::string> result(range.size());
  std::transform(range.begin(), range.end(), result.begin(), name);
  return result;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
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

Rgb<double> parse_value(const std::string& where, std::string_view text, const ParameterInfo& p) {
  const auto channels = split(text, '/');
  if (channels.size() == 1) return Rgb<double>(parse_number(where, text, p));
  if (!p.colour || channels.size() != 3)
    throw Error(where, "'" + p.key + "' wants " +
                           (p.colour ? "one number or r/g/b" : "one number") + ", not '" +
                           std::string(text) + "'");
  return {parse_number(where, channels[0], p), parse_number(where, channels[1], p),
          parse_number(where, channels[2], p)};
}

}  // namespace

void add(Entry entry) { entries().push_back(std::move(entry)); }

const std::vector<ModelInfo>& list() {
  static std::vector<ModelInfo> infos;
  if (infos.size() != entries().size()) {
    infos.clear();
    for (const Entry& entry : entries()) infos.push_back(entry.info);
  }
  return infos;
}

NamedModel make(std::string_view specification) {
  const auto colon = specification.find(':');
  const std::string name(specification.substr(0, colon));
  const auto entry = std::find_if(entries().begin(), entries().end(),
                                  [&](const Entry& e) { return e.info.name == name; });
  if (entry == entries().end())
    throw Error("unknown model '" + name + "'" +
                did_you_mean(name, names(entries(), [](const Entry& e) { return e.info.name; })));

  // A copied file whose name was not changed: one of the two would never be drawn.
  if (std::count_if(entry, entries().end(), [&](const Entry& e) { return e.info.name == name; }) >
      1)
    throw Error("model '" + name + "'", "two models have this name; rename one in its describe()");

  const auto& parameters = entry->info.parameters;
  Values values;
  for (const ParameterInfo& p : parameters) values.emplace_back(p.key, p.initial);
  std::vector<bool> given(parameters.size());
  if (colon != std::string_view::npos) {
    for (const std::string_view assignment : split(specification.substr(colon + 1), ',')) {
      const auto equals = assignment.find('=');
      const std::string key(assignment.substr(0, equals));
      if (key.empty() || equals == std::string_view::npos)
        throw Error("model '" + name + "'",
                    "expected key=value, not '" + std::string(assignment) + "'");
      const auto found = std::find_if(parameters.begin(), parameters.end(),
                                      [&](const ParameterInfo& p) { return p.key == key; });
      if (found == parameters.end())
        throw Error("model '" + name + "'",
                    "unknown parameter '" + key + "'" +
                        did_you_mean(key, names(parameters, [](auto& p) { return p.key; })));
      const auto index = std::size_t(found - parameters.begin());
      if (given[index]) throw Error("model '" + name + "'", "'" + key + "' is given twice");
      given[index] = true;
      values[index].second =
          parse_value("model '" + name + "'", assignment.substr(equals + 1), *found);
    }
  }
  return {std::string(specification), entry->make(values), std::move(values)};
}

}  // namespace scanlit::models
