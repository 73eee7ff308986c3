// The adapter between a formula and the engine: what a formula is given, and with which accuracy.
#include "rasterizer/formula_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/unit/reflection_span.h"

namespace scanlit {
namespace {

using namespace test;

// ------------------------------------------------------------------------------------ the cosines

float first_lane(Batch batch) {
  float lanes[Batch::lanes];
  batch.store(lanes);
  return lanes[0];
}

TEST(CosinePow, StatedErrorUpToExponent1e5) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst_batch = 0, worst_float = 0;
  for (int round = 0; round < 500000; ++round) {
    const auto n = float(std::pow(10.0, -1 + 6 * unit(random)));
    // Angles where the lobe is not 0 yet.
    const auto versine = float(std::min(1.0f, 80 / n) * unit(random) * unit(random));
    const double exact = std::exp(double(n) * std::log1p(-double(versine)));
    if (exact < 1e-37) continue;
    const auto error = [&](float value) {
      const double relative = std::abs(value - exact) / exact / (1 - std::log(exact));
      return std::isnan(relative) ? std::numeric_limits<double>::infinity() : relative;
    };
    const auto batch = Cosine<Batch>::of_versine(versine);
    worst_batch = std::max(worst_batch, error(first_lane(pow(batch, Batch(n)))));
    worst_float = std::max(worst_float, error(pow(Cosine<float>::of_versine(versine), n)));
  }
  EXPECT_LE(worst_batch, 1.6e-7);
  EXPECT_LE(worst_float, 1.6e-7);
}

TEST(CosinePow, StatedErrorOfWholeExponents) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const int n : {0, 1, 2, 5, 32, 50, 63, 64}) {
    double worst = 0;
    for (int round = 0; round < 20000; ++round) {
      const auto versine = float(unit(random) * unit(random));
      const double exact = std::exp(n * std::log1p(-double(versine)));
      const double power = first_lane(pow(Cosine<Batch>::of_versine(versine), double(n)));
      worst = std::max(worst, std::abs(power - exact));
    }
    EXPECT_LE(worst, 1e-7 * n) << n;
  }
  const auto right_angle = Cosine<Batch>::of_versine(Batch(1.0000001f));
  EXPECT_EQ(first_lane(pow(right_angle, 3.0)), 0);
  EXPECT_EQ(first_lane(pow(right_angle, 0.0)), 1);
}

TEST(CosinePow, AtAndBeyondARightAngle) {
  for (const float versine : {1.0f, 1.0000001f, 1.5f, 2.0f}) {
    const auto c = Cosine<Batch>::of_versine(versine);
    for (const float n : {0.01f, 1.0f, 50.0f, 1e5f}) {
      EXPECT_EQ(first_lane(pow(c, Batch(n))), 0) << versine << ' ' << n;
      EXPECT_EQ(pow(Cosine<float>::of_versine(versine), n), 0) << versine << ' ' << n;
      EXPECT_EQ(pow(Cosine<double>::of_versine(versine), double(n)), 0) << versine << ' ' << n;
    }
    EXPECT_EQ(first_lane(pow(c, Batch(0))), 1);
    EXPECT_EQ(pow(Cosine<float>::of_versine(versine), 0.0f), 1);
  }
  EXPECT_EQ(first_lane(pow(Cosine<Batch>::of_versine(0), Batch(1e5f))), 1);
}

template <class T>
Vec3<T> vec3(const glm::dvec3& v) {
  return {T(float(v.x)), T(float(v.y)), T(float(v.z))};
}
glm::dvec3 rounded(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }

TEST(Cosines, AreThoseOfTheDirections) {
  std::mt19937 random(2);
  for (int round = 0; round < 20000; ++round) {
    const glm::dvec3 n = direction(random), l = direction(random), v = direction(random);
    const glm::dvec3 h = glm::normalize(l + v);
    const Cosines<double> c = cosines<double>({n.x, n.y, n.z}, {l.x, l.y, l.z}, {v.x, v.y, v.z});
    EXPECT_NEAR(c.n_l, glm::dot(n, l), 1e-12);
    EXPECT_NEAR(c.n_v, std::max(glm::dot(n, v), min_n_v), 1e-12);
    EXPECT_NEAR(c.v_h, glm::dot(v, h), 1e-12);
    EXPECT_NEAR(c.n_h, glm::dot(n, h), 1e-12);
    EXPECT_NEAR(c.n_h.versine, 1 - glm::dot(n, h), 1e-12);
  }
}

TEST(Cosines, KeepASmallAngleBetweenNormalAndHalfVector) {
  // N.H = 1 - 5e-11: 1 in float, and its angle gone; the versine still has it.
  std::mt19937 random(3);
  for (int round = 0; round < 10000; ++round) {
    const glm::dvec3 h = direction(random);
    const glm::dvec3 across = glm::normalize(glm::cross(h, direction(random)));
    const double angle = std::uniform_real_distribution<double>(0.1, 1.2)(random);
    const glm::dvec3 l = rounded(h * std::cos(angle) + across * std::sin(angle));
    const glm::dvec3 v = rounded(h * std::cos(angle) - across * std::sin(angle));
    const glm::dvec3 n = rounded(glm::normalize(h + 1e-3 * direction(random)));
    const double versine = 1 - glm::dot(glm::normalize(n), glm::normalize(l + v));
    const auto c = cosines(vec3<Batch>(n), vec3<Batch>(l), vec3<Batch>(v));
    EXPECT_NEAR(first_lane(c.n_h.versine), versine, 1e-9);
  }
}

TEST(Cosines, DoNotExceedOne) {
  std::mt19937 random(5);
  bool rounded_up = false;
  for (int round = 0; round < 1000; ++round) {
    const auto n = vec3<float>(direction(random));
    const auto c = cosines(n, n, n);
    for (const float cosine : {c.n_l, c.n_v, float(c.n_h), c.v_h}) EXPECT_LE(cosine, 1);
    rounded_up |= dot(n, n) > 1;
  }
  EXPECT_TRUE(rounded_up) << "or this tests nothing";
}

TEST(Cosines, AreFiniteForDegenerateDirections) {
  const glm::dvec3 z(0, 0, 1), x(1, 0, 0);
  const glm::dvec3 nearly_x = glm::normalize(glm::dvec3(1, 1e-7, 0));
  for (const auto& [l, v] : {std::pair{z, z}, {z, -z}, {x, -x}, {nearly_x, -x}, {-z, -z}, {x, x}}) {
    const auto c = cosines(vec3<float>(z), vec3<float>(l), vec3<float>(v));
    for (const float value : {c.n_l, c.n_v, float(c.n_h), c.n_h.versine, c.v_h})
      EXPECT_TRUE(std::isfinite(value));
    EXPECT_GE(c.n_v, float(min_n_v));
    EXPECT_LE(std::abs(float(c.n_h)), 1.000001f);
  }
  const auto opposite = cosines(vec3<float>(z), vec3<float>(x), vec3<float>(-x));
  EXPECT_EQ(opposite.n_h, 0) << "H is taken as perpendicular to N";
  EXPECT_EQ(opposite.v_h, 0);
}

// ------------------------------------------------------------------- what a formula is called with

/// Formulas that return what they are given.
struct OfCosines {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = {c.n_l, c.n_v, c.v_h}, .glossy = {c.n_h, c.n_h.versine, T(0)}};
  }
};
struct OfFrame {
  double scale = 1;
  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const ShadingFrame<T>& f) const {
    return {.diffuse = {f.l.x * T(scale), f.l.y * T(scale), f.l.z * T(scale)},
            .glossy = {f.h.x, f.h.y, f.v.y}};
  }
};
struct OfPoint {
  std::vector<float> table = {0.5f};  // makes the formula one that is not copied for every span
  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const SurfacePoint<T>& p) const {
    const Vec3<T>& at = p.object_position;
    return {.diffuse = {at.x, at.y, at.z}, .glossy = {p.u, p.v, T(table[0])}};
  }
};
struct OfBoth {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f,
                           const SurfacePoint<T>& p) const {
    return {.diffuse = {c.n_l, f.l.x, p.u}, .glossy = {p.object_position.z, f.v.x, p.v}};
  }
};

TEST(FormulaModel, NeedsFollowFromTheArguments) {
  const auto needs = [](const ReflectionModel& model) {
    return std::pair(model.needs().frame, model.needs().surface_point);
  };
  EXPECT_EQ(needs(FormulaModel(OfCosines())), std::pair(false, false));
  EXPECT_EQ(needs(FormulaModel(OfFrame())), std::pair(true, false));
  EXPECT_EQ(needs(FormulaModel(OfPoint())), std::pair(false, true));
  EXPECT_EQ(needs(FormulaModel(OfBoth())), std::pair(true, true));
}

TEST(FormulaModel, GivesTheDirectionsInTheShadingFrame) {
  std::mt19937 random(4);
  constexpr std::size_t size = 100;
  Span span = random_span(size, random);
  const auto result = span.evaluate(FormulaModel(OfFrame()));
  for (std::size_t i = 0; i < size; ++i) {
    const glm::dvec3 n = span.get(i, Span::normal), t = span.get(i, Span::tangent);
    const glm::dvec3 b = glm::cross(n, t);
    const glm::dvec3 l = span.get(i, Span::to_light), v = span.get(i, Span::to_viewer);
    const glm::dvec3 h = glm::normalize(l + v);
    EXPECT_NEAR(result[i][0], glm::dot(l, t), 1e-6);
    EXPECT_NEAR(result[i][1], glm::dot(l, b), 1e-6);
    EXPECT_NEAR(result[i][2], glm::dot(l, n), 1e-6);
    EXPECT_NEAR(result[i][3], glm::dot(h, t), 1e-6);
    EXPECT_NEAR(result[i][4], glm::dot(h, b), 1e-6);
    EXPECT_NEAR(result[i][5], glm::dot(v, b), 1e-6);
  }
}

TEST(FormulaModel, GivesThePointOfTheSurface) {
  std::mt19937 random(5);
  constexpr std::size_t size = 100;
  Span span = random_span(size, random);
  const auto result = span.evaluate(FormulaModel(OfPoint()));
  const auto both = span.evaluate(FormulaModel(OfBoth()));
  for (std::size_t i = 0; i < size; ++i) {
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(double(result[i][std::size_t(c)]), span.get(i, Span::position)[c]);
    EXPECT_EQ(result[i][3], span.uv(i, 0));
    EXPECT_EQ(result[i][4], span.uv(i, 1));
    EXPECT_EQ(result[i][5], 0.5f);
    const glm::dvec3 l = span.get(i, Span::to_light), t = span.get(i, Span::tangent);
    EXPECT_NEAR(both[i][1], glm::dot(l, t), 1e-6);
    EXPECT_EQ(both[i][2], span.uv(i, 0));
    EXPECT_EQ(both[i][5], span.uv(i, 1));
  }
}

TEST(FormulaModel, ASingleQueryIsTheSpanInItsOwnFrame) {
  std::mt19937 random(6);
  const FormulaModel<OfFrame> frame{OfFrame()};
  const FormulaModel<OfPoint> point{OfPoint()};
  for (int round = 0; round < 1000; ++round) {
    glm::dvec3 l = direction(random), v = direction(random);
    l.z = std::abs(l.z), v.z = std::abs(v.z);
    const glm::dvec3 h = glm::normalize(l + v);
    const auto seen = frame.evaluate(Vec3<double>{l.x, l.y, l.z}, {v.x, v.y, v.z}, {});
    EXPECT_NEAR(seen.diffuse.r, l.x, 1e-12);
    EXPECT_NEAR(seen.diffuse.b, l.z, 1e-12);
    EXPECT_NEAR(seen.glossy.r, h.x, 1e-12);
    EXPECT_NEAR(seen.glossy.b, v.y, 1e-12);
    const auto at = point.evaluate(vec3<float>(l), vec3<float>(v), {{1, 2, 3}, 4, 5});
    EXPECT_EQ(at.diffuse, Rgb<float>(1, 2, 3));
    EXPECT_EQ(at.glossy, Rgb<float>(4, 5, 0.5f));
  }
}

TEST(FormulaModel, LightOrViewerBelowTheHorizon) {
  const FormulaModel<OfPoint> one{OfPoint()};
  const auto query = [&](double l_z, double v_z) {
    const double l_x = std::sqrt(1 - l_z * l_z), v_x = std::sqrt(1 - v_z * v_z);
    return one.evaluate(Vec3<double>{l_x, 0, l_z}, {v_x, 0, v_z}, {{1, 1, 1}, 1, 1}).diffuse.r;
  };
  EXPECT_EQ(query(0.5, 0.5), 1);
  EXPECT_EQ(query(1e-9, 1e-9), 1);
  for (const auto& [l_z, v_z] : {std::pair{0.0, 0.5}, {-0.5, 0.5}, {0.5, 0.0}, {0.5, -0.5}})
    EXPECT_EQ(query(l_z, v_z), 0) << l_z << ' ' << v_z;

  // In a span the points are visible, whatever the interpolated normal says of the viewer.
  Span span(2);
  span.put(0, {0, 0, 1}, {0, 0.6, 0.8}, {0, 0.8, -0.6});
  span.put(1, {0, 0, 1}, {0, 0.6, -0.8}, {0, 0.8, 0.6});
  const auto result = span.evaluate(FormulaModel(OfCosines()));
  EXPECT_FLOAT_EQ(result[0][0], 0.8f);
  EXPECT_FLOAT_EQ(result[0][1], float(min_n_v));
  for (const float value : result[1]) EXPECT_EQ(value, 0);
}

TEST(FormulaModel, SpansOfEveryLength) {
  std::mt19937 random(7);
  for (std::size_t size = 1; size <= 70; ++size) {
    Span span = random_span(size, random);
    const auto result = span.evaluate(FormulaModel(OfCosines()));
    for (std::size_t i = 0; i < size; ++i) {
      const glm::dvec3 n = span.get(i, Span::normal), l = span.get(i, Span::to_light);
      EXPECT_NEAR(result[i][0], glm::dot(n, l), 1e-6) << i << " of " << size;
    }
  }
}

TEST(FormulaModel, ParametersReachTheFormula) {
  Span span(1);
  span.put(0, {0, 0, 1}, {0.6, 0, 0.8}, {0, 0, 1});
  span.put(0, Span::tangent, {1, 0, 0});
  EXPECT_FLOAT_EQ(span.evaluate(FormulaModel(OfFrame{.scale = 3}))[0][0], 1.8f);
}

}  // namespace
}  // namespace scanlit
