// Asking a reflection model, in tests: its values, directions to ask for, parameters to try.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "models/registry.h"
#include "rasterizer/error.h"
#include "tests/unit/reflection_span.h"

namespace scanlit::test {

inline std::array<double, 6> channels(const Reflection<double>& r) {
  return {r.diffuse.r, r.diffuse.g, r.diffuse.b, r.glossy.r, r.glossy.g, r.glossy.b};
}
inline std::array<float, 6> channels(const Reflection<float>& r) {
  return {r.diffuse.r, r.diffuse.g, r.diffuse.b, r.glossy.r, r.glossy.g, r.glossy.b};
}

inline std::array<double, 6> in_double(const ReflectionModel& model, const glm::dvec3& l,
                                       const glm::dvec3& v) {
  return channels(model.evaluate(Vec3<double>{l.x, l.y, l.z}, {v.x, v.y, v.z}));
}
inline std::array<float, 6> in_float(const ReflectionModel& model, const glm::vec3& l,
                                     const glm::vec3& v) {
  return channels(model.evaluate(Vec3<float>{l.x, l.y, l.z}, {v.x, v.y, v.z}));
}

/// The words of the refusal where a specification makes no model.
inline std::string error_of(std::string_view specification) {
  try {
    models::make(specification);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// "0.1": as the registry reads it.
inline std::string text(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

/// A model with its default parameters, with each choice, with each parameter at the ends of its
/// range and between, where it has a meaning, and with all colours at their largest.
inline std::vector<std::string> specifications(const models::ModelInfo& info) {
  std::vector<std::string> result = {info.name};
  std::string brightest;
  for (const auto& p : info.parameters) {
    std::vector<std::string> begins;  // "NAME:D=blinn,", for each choice that gives p a meaning
    const auto equals = p.only_with.find('=');
    if (equals == std::string::npos)
      begins = {info.name + ":"};
    else
      for (const auto word :
           models::split_outside_parentheses(std::string_view(p.only_with).substr(equals + 1), '|'))
        begins.push_back(info.name + ":" + p.only_with.substr(0, equals + 1) + std::string(word) +
                         ",");
    for (const std::string& begin : begins) {
      for (const std::string& word : p.choices) result.push_back(begin + p.key + "=" + word);
      if (p.kind != models::ParameterKind::number && p.kind != models::ParameterKind::colour)
        continue;
      for (const double value : {p.min, p.max, 0.05, 1.0, 20.0, 1000.0, 12000.0})
        if (value >= p.min && value <= p.max) result.push_back(begin + p.key + "=" + text(value));
    }
    if (p.kind == models::ParameterKind::colour && p.only_with.empty())
      brightest += (brightest.empty() ? ":" : ",") + p.key + "=" + text(p.max);
  }
  result.push_back(info.name + brightest);
  return result;
}

struct Pair {
  glm::vec3 l, v;
};

inline glm::dvec3 at(double cos_theta, double phi) {
  const double sin_theta = std::sqrt(1 - cos_theta * cos_theta);
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

/// Directions in the shading frame: over the sphere, grazing, about the mirror direction
/// as near as the sharpest lobe wants, and degenerate.
inline std::vector<Pair> direction_pairs(std::size_t count, unsigned seed) {
  const glm::dvec3 z(0, 0, 1), x(1, 0, 0), slant = at(0.6, 1);
  const glm::dvec3 mirrored(-slant.x, -slant.y, slant.z), below = at(-0.4, 2);
  std::vector<Pair> pairs = {{z, z},           {slant, slant},
                             {slant, -slant},  {slant, mirrored},
                             {x, -x},          {x, x},
                             {z, -z},          {z, x},
                             {x, z},           {below, slant},
                             {slant, below},   {below, below},
                             {z, at(1e-7, 0)}, {at(1e-7, 0), at(1e-7, 3.1415927)}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto grazing = [&] {
    return at(std::pow(10.0, -7 * unit(random)), 2 * std::numbers::pi * unit(random));
  };
  while (pairs.size() < count) {
    const glm::dvec3 a = direction(random), b = grazing();
    const double nearness = std::pow(10.0, -5 * unit(random));
    const glm::dvec3 mirror = glm::dvec3(-b.x, -b.y, b.z) + nearness * direction(random);
    pairs.insert(pairs.end(), {{a, direction(random)},
                               {b, grazing()},
                               {b, glm::normalize(mirror)},
                               {{a.x, a.y, std::abs(a.z)}, b}});
  }
  return pairs;
}

inline Span span_of(const std::vector<Pair>& pairs) {
  Span span(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    span.put(i, {0, 0, 1}, pairs[i].l, pairs[i].v);
    span.put(i, Span::tangent, {1, 0, 0});
  }
  return span;
}

}  // namespace scanlit::test
