// What the tests of tangents ask of a vector.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace scanlit::test {

inline void expect_vector(const glm::vec3& actual, const glm::vec3& expected,
                          float tolerance = 1e-6f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "component " << c;
}

inline bool lies_in_surface(const glm::vec3& tangent, const glm::vec3& normal) {
  return std::abs(glm::length(glm::dvec3(tangent)) - 1) <= 1e-6 &&
         std::abs(glm::dot(glm::dvec3(tangent), glm::dvec3(normal))) <= 1e-6;
}

}  // namespace scanlit::test
