// Spans of directions for tests of reflection models, laid out as the renderer lays them out.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <vector>

#include "rasterizer/reflection_model.h"

namespace scanlit::test {

/// A random unit vector.
inline glm::dvec3 direction(std::mt19937& random) {
  std::normal_distribution<double> coordinate;
  return glm::normalize(glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
}

/// Arrays for a span, as the renderer has them: whole vectors, and what lies beyond the span's end
/// is left over from before.
class Span {
 public:
  explicit Span(std::size_t size) : size_(size) {
    const std::size_t padded = (size + max_lanes - 1) / max_lanes * max_lanes;
    for (auto& array : inputs_) array.assign(padded, std::numeric_limits<float>::quiet_NaN());
    for (auto& array : outputs_) array.assign(padded + 1, unwritten);
  }

  void put(std::size_t i, int first, const glm::dvec3& v) {
    for (int c = 0; c < 3; ++c) inputs_[first + c][i] = float(v[c]);
  }
  void put(std::size_t i, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
    put(i, normal, n), put(i, to_light, l), put(i, to_viewer, v);
  }
  glm::dvec3 get(std::size_t i, int first) const {
    return {inputs_[first][i], inputs_[first + 1][i], inputs_[first + 2][i]};
  }
  float uv(std::size_t i, int c) const { return inputs_[texcoord + c][i]; }

  /// The model's diffuse and glossy parts, six values a point.
  std::vector<std::array<float, 6>> evaluate(const ReflectionModel& model) {
    PointSpan points{.size = size_};
    DirectionSpan in{.size = size_};
    ReflectionSpan out;
    const Needs needs = model.needs();
    for (int c = 0; c < 3; ++c) {
      in.normal[c] = inputs_[normal + c].data();
      in.to_light[c] = inputs_[to_light + c].data();
      in.to_viewer[c] = inputs_[to_viewer + c].data();
      if (needs.frame) in.tangent[c] = inputs_[tangent + c].data();
      points.object_position[c] = inputs_[position + c].data();
      points.vertex_colour[c] = inputs_[colour + c].data();
      if (c < 2) points.texcoord[c] = inputs_[texcoord + c].data();
      out.diffuse[c] = outputs_[c].data();
      out.glossy[c] = outputs_[3 + c].data();
    }
    if (needs.surface_point) in.points = &points;
    std::vector<std::vector<float>> varying(needs.parameters,
                                            std::vector<float>(inputs_[0].size()));
    std::vector<float*> parameters;
    for (auto& array : varying) parameters.push_back(array.data());
    if (needs.parameters) model.evaluate_parameters(points, parameters.data());
    in.parameters = parameters.data();
    model.evaluate(in, out);
    std::vector<std::array<float, 6>> result(size_);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t c = 0; c < 6; ++c) result[i][c] = outputs_[c][i];
    for (const auto& array : outputs_) EXPECT_EQ(array.back(), unwritten) << "beyond the vectors";
    return result;
  }

  static constexpr int normal = 0, to_light = 3, to_viewer = 6, tangent = 9, position = 12,
                       texcoord = 15, colour = 17;

 private:
  static constexpr float unwritten = -12345;
  std::size_t size_;
  std::array<std::vector<float>, 20> inputs_;
  std::array<std::vector<float>, 6> outputs_;
};

/// Random directions above the horizon, tangents, positions and texture coordinates.
inline Span random_span(std::size_t size, std::mt19937& random) {
  Span span(size);
  for (std::size_t i = 0; i < size; ++i) {
    const glm::dvec3 n = direction(random), l = direction(random), v = direction(random);
    span.put(i, n, glm::dot(l, n) > 0 ? l : -l, glm::dot(v, n) > 0 ? v : -v);
    span.put(i, Span::tangent, glm::normalize(glm::cross(n, direction(random))));
    span.put(i, Span::position, direction(random) * 10.0);
    span.put(i, Span::texcoord, direction(random));
    span.put(i, Span::colour, {0.2, 0.5, 1.0});
  }
  return span;
}

}  // namespace scanlit::test
