// A parameter that varies over the surface but has the same value everywhere must give the model in
// which it is constant; directions of object space must come to the shading frame.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "models/inputs/checker.h"
#include "models/registry.h"
#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;

using models::ParameterInfo;
using models::ParameterKind;

/// The engine's part: points with their frames, and parameter arrays filled before the lights.
class Points {
 public:
  Points(std::size_t size, std::mt19937& random) : size_(size), padded_(size + max_lanes) {
    for (auto& array : arrays_) array.assign(padded_, 0.0f);
    for (std::size_t i = 0; i < size; ++i) {
      const glm::dvec3 n = direction(random);
      put(i, normal, n);
      put(i, tangent, glm::normalize(glm::cross(n, direction(random))));
      put(i, position, direction(random));
      put(i, texcoord, direction(random));
      const glm::dvec3 v = direction(random);
      put(i, to_viewer, glm::dot(v, n) > 0 ? v : -v);
    }
  }

  void set_transform(const glm::mat3& m) {
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) transform_[c][r] = m[c][r];
  }
  glm::dvec3 get(std::size_t i, int first) const {
    return {arrays_[first][i], arrays_[first + 1][i], arrays_[first + 2][i]};
  }

  /// Six values a point and light.
  std::vector<std::array<float, 6>> evaluate(const ReflectionModel& model,
                                             const std::vector<glm::dvec3>& lights) {
    PointSpan points{.size = size_};
    DirectionSpan in{.size = size_};
    ReflectionSpan out;
    std::vector<float> light[3], results[6];
    for (auto& array : results) array.assign(padded_, 0.0f);
    for (int c = 0; c < 3; ++c) {
      light[c].assign(padded_, 0.0f);
      in.normal[c] = points.normal[c] = arrays_[normal + c].data();
      in.tangent[c] = points.tangent[c] = arrays_[tangent + c].data();
      in.to_viewer[c] = arrays_[to_viewer + c].data();
      in.to_light[c] = light[c].data();
      points.object_position[c] = arrays_[position + c].data();
      points.vertex_colour[c] = arrays_[position + c].data();
      if (c < 2) points.texcoord[c] = arrays_[texcoord + c].data();
      out.diffuse[c] = results[c].data(), out.glossy[c] = results[3 + c].data();
      for (int r = 0; r < 3; ++r) points.world_from_object[c][r] = transform_[c][r];
    }
    parameters_.assign(model.needs().parameters, std::vector<float>(padded_));
    std::vector<float*> pointers;
    for (auto& array : parameters_) pointers.push_back(array.data());
    if (!pointers.empty()) model.evaluate_parameters(points, pointers.data());
    in.points = &points, in.parameters = pointers.data();
    std::vector<std::array<float, 6>> values;
    for (const glm::dvec3& l : lights) {
      for (int c = 0; c < 3; ++c) light[c].assign(padded_, float(l[c]));
      model.evaluate(in, out);
      for (std::size_t i = 0; i < size_; ++i) {
        values.emplace_back();
        for (std::size_t c = 0; c < 6; ++c) values.back()[c] = results[c][i];
      }
    }
    return values;
  }
  float parameter(std::size_t array, std::size_t i) const { return parameters_[array][i]; }

  static constexpr int normal = 0, tangent = 3, to_viewer = 6, position = 9, texcoord = 12;

 private:
  void put(std::size_t i, int first, const glm::dvec3& v) {
    for (int c = 0; c < 3; ++c) arrays_[first + c][i] = float(v[c]);
  }
  std::size_t size_, padded_;
  std::vector<float> arrays_[15];
  std::vector<std::vector<float>> parameters_;
  float transform_[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};

/// A value that float holds, inside the range, not the default.
std::string some_value(const ParameterInfo& p) {
  const double low = std::max(p.min, p.max > 100 ? 1.0 : p.min), high = std::min(p.max, 100.0);
  return text(double(float(low + 0.375 * (high - low))));
}

/// "MODEL:D=ggx," or "MODEL:": what stands before a parameter to give it a meaning.
std::string begin_of(const models::ModelInfo& info, const ParameterInfo& p) {
  const auto end = p.only_with.find('|');
  return info.name + ':' + (p.only_with.empty() ? "" : p.only_with.substr(0, end) + ',');
}

TEST(VaryingModel, AConstantInputGivesTheConstantModel) {
  std::mt19937 random(1);
  Points points(100, random);
  const std::vector<glm::dvec3> lights = {direction(random), direction(random), direction(random)};
  const std::vector<Pair> pairs = direction_pairs(200, 2);
  int parameters = 0;
  for (const models::ModelInfo& info : models::list())
    for (const ParameterInfo& p : info.parameters) {
      if (!p.varies || (p.kind != ParameterKind::number && p.kind != ParameterKind::colour))
        continue;
      ++parameters;
      const std::string begin = begin_of(info, p) + p.key + '=', value = some_value(p);
      const auto constant = models::make(begin + value).model;
      const auto varying = models::make(begin + "checker(a=" + value + ",b=" + value + ')').model;
      ASSERT_EQ(varying->needs().parameters, p.kind == ParameterKind::colour ? 3u : 1u) << begin;

      const auto expected = points.evaluate(*constant, lights),
                 given = points.evaluate(*varying, lights);
      for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t c = 0; c < 6; ++c)
          ASSERT_NEAR(given[i][c], expected[i][c], 1e-6 + 2e-5 * expected[i][c])
              << begin << value << ", span";
      for (const auto& [l, v] : pairs) {
        const auto exact = in_double(*constant, l, v), seen = in_double(*varying, l, v);
        const auto exact_float = in_float(*constant, l, v), seen_float = in_float(*varying, l, v);
        for (std::size_t c = 0; c < 6; ++c) {
          ASSERT_NEAR(seen[c], exact[c], 1e-9 * (1 + exact[c])) << begin << value << ", double";
          ASSERT_NEAR(seen_float[c], exact_float[c], 1e-6 + 2e-5 * exact_float[c])
              << begin << value << ", float";
        }
      }
    }
  EXPECT_GE(parameters, 10);
}

/// An input that is what a test wants it to be.
class Given final : public models::Input {
 public:
  explicit Given(Rgb<float> value) : value_(value) {}
  void evaluate(const PointSpan& points, std::size_t channels, float* const* out) const override {
    const float all[3] = {value_.r, value_.g, value_.b};
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t i = 0; i < points.size; ++i) out[c][i] = all[c];
  }

 private:
  Rgb<float> value_;
};

/// What reflects the direction it is given, and a number and a colour.
template <class P = double>
struct Probe {
  Vec3<P> u{P(1), P(0), P(0)};
  P number{0.5};
  Rgb<P> colour{P(0.5)};

  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const ShadingFrame<T>&) const {
    return {.diffuse = {T(u.x), T(u.y), T(u.z)}, .glossy = colour * T(number)};
  }
  static models::Description<Probe> describe() {
    return {.name = "probe",
            .year = 0,
            .title = "",
            .source = "",
            .reciprocal = false,
            .energy_bounded = false,
            .parameters = {{"u", &Probe::u, "direction"},
                           {"number", &Probe::number, 0.25, 0.75, "number"},
                           {"colour", &Probe::colour, 0, 1, "colour"}}};
  }
};

std::shared_ptr<const ReflectionModel> probe(std::size_t parameter, Rgb<float> value) {
  return std::make_shared<models::VaryingModel<Probe<>>>(
      Probe<>{}, std::vector<models::Varying>{{parameter, std::make_shared<Given>(value)}});
}

TEST(VaryingModel, DirectionsTurnWithTheObjectIntoTheShadingFrame) {
  std::mt19937 random(3);
  constexpr std::size_t size = 50;
  for (int round = 0; round < 20; ++round) {
    Points points(size, random);
    // Any linear map: turned, sheared, scaled unevenly, mirrored.
    glm::dmat3 m;
    for (int c = 0; c < 3; ++c) m[c] = direction(random) * std::pow(10.0, round % 5 - 2);
    points.set_transform(glm::mat3(m));
    const glm::dvec3 d = 3.0 * direction(random);
    const auto model = probe(0, {float(d.x), float(d.y), float(d.z)});
    EXPECT_TRUE(model->needs().frame);
    points.evaluate(*model, {{0, 0, 1}});
    for (std::size_t i = 0; i < size; ++i) {
      const glm::dvec3 n = points.get(i, Points::normal), t = points.get(i, Points::tangent);
      const glm::dvec3 world = glm::normalize(m * d);
      EXPECT_NEAR(points.parameter(0, i), glm::dot(t, world), 2e-5);
      EXPECT_NEAR(points.parameter(1, i), glm::dot(glm::cross(n, t), world), 2e-5);
      EXPECT_NEAR(points.parameter(2, i), glm::dot(n, world), 2e-5);
    }
  }
}

TEST(VaryingModel, ADirectionOfNoLengthIsTheTangent) {
  const auto value = probe(0, {0, 0, 0})->evaluate(Vec3<double>{0, 0, 1}, {0, 0, 1}).diffuse;
  EXPECT_EQ(value, Rgb<double>(1, 0, 0));
}

TEST(VaryingModel, ValuesAreBroughtIntoTheParametersRange) {
  const auto number = [](float value) {
    return probe(1, Rgb<float>(value))->evaluate(Vec3<double>{0, 0, 1}, {0, 0, 1}).glossy.r * 2;
  };
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(number(0.5f), 0.5);
  EXPECT_EQ(number(-1), 0.25);
  EXPECT_EQ(number(7), 0.75);
  EXPECT_EQ(number(inf), 0.75);
  EXPECT_EQ(number(-inf), 0.25);
  EXPECT_EQ(number(std::nanf("")), 0.25) << "NaN is the lower end";
}

TEST(VaryingModel, InputsAreRefusedWhereNothingCanVary) {
  EXPECT_EQ(error_of("lambert:kd=checkers(a=1)"),
            "unknown input 'checkers'; did you mean 'checker'?");
  EXPECT_EQ(error_of("lambert:kd=checker(c=1)"),
            "model 'lambert', checker: unknown parameter 'c'; there are: a, b, count");
  EXPECT_EQ(error_of("blinn-phong:normalised=checker"),
            "model 'blinn-phong': 'normalised' cannot vary; it wants one value, not 'checker'");
}

}  // namespace
}  // namespace scanlit
