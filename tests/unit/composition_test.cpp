// Models made of models: sums, and a clear coat over a base.
#include <cmath>
#include <numbers>

#include "models/albedo.h"
#include "models/clear_coat.h"
#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;
using std::numbers::pi;

glm::dvec3 upper(std::mt19937& random) {
  glm::dvec3 d = direction(random);
  d.z = std::max(std::abs(d.z), 2 * min_n_v);
  return d;
}

TEST(Sum, AddsItsModelsEachWithItsFactor) {
  const auto sum = models::make("sum:.5*(phong:n=7),(ward:kd=.1),2*(lambert)").model;
  const auto phong = models::make("phong:n=7").model, ward = models::make("ward:kd=.1").model,
             lambert = models::make("lambert").model;
  EXPECT_TRUE(sum->needs().frame) << "Ward's model does";
  std::mt19937 random(1);
  for (int round = 0; round < 100; ++round) {
    const glm::dvec3 l = upper(random), v = upper(random);
    const auto value = in_double(*sum, l, v);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(value[c],
                  0.5 * in_double(*phong, l, v)[c] + in_double(*ward, l, v)[c] +
                      2 * in_double(*lambert, l, v)[c],
                  1e-12);
  }
}

/// One span of 5 points whose texture coordinates differ; all else is the same.
class Points {
 public:
  Points() {
    for (std::size_t i = 0; i < max_lanes; ++i) {
      u_[i] = 0.03f * float(i), v_[i] = 0.02f;
      z_[i] = 1, half_[i] = std::sqrt(0.5f);
    }
    for (int c = 0; c < 3; ++c) {
      points_.object_position[c] = zero_, points_.vertex_colour[c] = z_;
      points_.normal[c] = points_.tangent[c] = in_.normal[c] = in_.tangent[c] = zero_;
      in_.to_light[c] = in_.to_viewer[c] = zero_;
    }
    points_.texcoord[0] = u_, points_.texcoord[1] = v_;
    points_.normal[2] = in_.normal[2] = in_.to_viewer[2] = z_;
    points_.tangent[0] = in_.tangent[0] = z_;
    in_.to_light[0] = in_.to_light[2] = half_;
    in_.points = &points_;
  }

  void expect_as_single_queries(const ReflectionModel& model) {
    const std::size_t count = model.needs().parameters;
    std::vector<float> storage(count * max_lanes);
    std::vector<float*> arrays(count);
    for (std::size_t k = 0; k < count; ++k) arrays[k] = &storage[k * max_lanes];
    model.evaluate_parameters(points_, arrays.data());
    in_.parameters = arrays.data();
    float values[6][max_lanes];
    ReflectionSpan out;
    for (int c = 0; c < 3; ++c) out.diffuse[c] = values[c], out.glossy[c] = values[3 + c];
    model.evaluate(in_, out);
    for (std::size_t i = 0; i < points_.size; ++i) {
      SurfacePoint<double> point;
      point.u = u_[i], point.v = v_[i];
      const auto exact =
          channels(model.evaluate({std::sqrt(0.5), 0, std::sqrt(0.5)}, {0, 0, 1}, point));
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(values[c][i], exact[c], 1e-5 * std::max(1.0, exact[c])) << i << ' ' << c;
    }
  }

 private:
  float u_[max_lanes], v_[max_lanes], z_[max_lanes], half_[max_lanes], zero_[max_lanes] = {};
  PointSpan points_{.size = 5};
  DirectionSpan in_{.size = 5};
};

TEST(Composition, WhatVariesReachesEveryPart) {
  const std::string a = "(lambert:kd=checker(a=.9/.5/.1,b=.1,count=20))";
  const std::string b = "(phong:kd=.1,n=checker(a=3,b=30,count=30),ks=.3)";
  const auto sum = models::make("sum:" + a + ",.5*" + b + ",(ward)").model;
  EXPECT_EQ(sum->needs().parameters, 4u);
  Points().expect_as_single_queries(*sum);
  Points().expect_as_single_queries(*models::make("clear-coat:base=" + a).model);
  Points().expect_as_single_queries(
      *models::make("clear-coat:base=(sum:" + a + "," + b + ")").model);
}

TEST(Sum, Refusals) {
  const std::string wants =
      "model 'sum': wants models, (MODEL) or .5*(MODEL), with factors from 0 to 100; not ";
  EXPECT_EQ(error_of("sum"), "model 'sum': of which models? sum:(MODEL),.5*(MODEL)");
  EXPECT_EQ(error_of("sum:lambert"), wants + "'lambert'");
  EXPECT_EQ(error_of("sum:-1*(lambert)"), wants + "'-1*(lambert)'");
  EXPECT_EQ(error_of("sum:2(lambert)"), wants + "'2(lambert)'");
  EXPECT_EQ(error_of("sum:nan*(lambert)"), wants + "'nan*(lambert)'");
  EXPECT_EQ(error_of("sum:a=(lambert)"), wants + "'a=(lambert)'");
  EXPECT_EQ(error_of("sum:(lamber)"), "unknown model 'lamber'; did you mean 'lambert'?");
}

/// Fresnel's equations as Snell's law and two amplitudes.
double fresnel(double cos_i, double eta) {
  const double theta_i = std::acos(cos_i), theta_t = std::asin(std::sin(theta_i) / eta);
  const double s =
      (std::cos(theta_i) - eta * std::cos(theta_t)) / (std::cos(theta_i) + eta * std::cos(theta_t));
  const double p =
      (eta * std::cos(theta_i) - std::cos(theta_t)) / (eta * std::cos(theta_i) + std::cos(theta_t));
  return (s * s + p * p) / 2;
}

double smith_lambda(double cosine, double a) {
  const double tan_theta = std::tan(std::acos(cosine));
  return (std::sqrt(1 + a * a * tan_theta * tan_theta) - 1) / 2;
}

TEST(ClearCoat, IsTheFormulaInItsHeader) {
  const double eta = 1.4, a = 0.2, internal = models::internal_reflectance(eta);
  const auto coated =
      models::make("clear-coat:base=(ward:kd=.6,rho=.3,ax=.3,ay=.5),eta=1.4,a=.2").model;
  const auto base = models::make("ward:kd=.6,rho=.3,ax=.3,ay=.5").model;
  std::mt19937 random(2);
  for (int round = 0; round < 2000; ++round) {
    const glm::dvec3 l = glm::normalize(upper(random)), v = glm::normalize(upper(random));
    const glm::dvec3 h = glm::normalize(l + v);
    const auto inside = [&](const glm::dvec3& d) {
      return glm::dvec3(d.x / eta, d.y / eta, std::sqrt(1 - (d.x * d.x + d.y * d.y) / (eta * eta)));
    };
    const auto under = in_double(*base, inside(l), inside(v));
    const double share =
        (1 - fresnel(l.z, eta)) * (1 - fresnel(v.z, eta)) / (eta * eta) * l.z / inside(l).z;
    const double d = a * a / (pi * std::pow((a * a - 1) * h.z * h.z + 1, 2));
    const double g = 1 / (1 + smith_lambda(l.z, a) + smith_lambda(v.z, a));
    const double mirrored = pi * d * g * fresnel(glm::dot(v, h), eta) / (4 * v.z);
    const auto value = in_double(*coated, l, v);
    EXPECT_NEAR(value[0], share * under[0] / (1 - 0.6 * internal), 1e-9);
    EXPECT_NEAR(value[3], share * under[3] + mirrored, 1e-9 * std::max(1.0, mirrored));
  }
}

TEST(ClearCoat, InternalReflectanceByQuadratureFromInside) {
  for (const double eta : {1.0, 1.33, 1.5, 2.5}) {
    constexpr int steps = 200000;
    const double critical = std::sqrt(1 - 1 / (eta * eta));  // cosine
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double c = (i + 0.5) / steps;
      const double f = c <= critical ? 1 : fresnel(std::sqrt(1 - eta * eta * (1 - c * c)), eta);
      sum += f * 2 * c / steps;
    }
    EXPECT_NEAR(models::internal_reflectance(eta), sum, 1e-4) << eta;
  }
}

double albedo(const std::string& specification, double theta_deg) {
  const glm::dvec3 v = at(std::cos(theta_deg * pi / 180), 0);
  return models::directional_albedo(*models::make(specification).model, {v.x, v.y, v.z}, 1e-4,
                                    300000)
      .value.r;
}

TEST(ClearCoat, OverWhiteLosesNothingAndOverBlackOnlyMirrors) {
  for (const double theta_deg : {0.0, 45.0, 80.0}) {
    const double mirrored = fresnel(std::cos(theta_deg * pi / 180), 1.5);
    EXPECT_NEAR(albedo("clear-coat:base=(lambert:kd=1),a=.005", theta_deg), 1, 1e-3);
    EXPECT_NEAR(albedo("clear-coat:base=(lambert:kd=0),a=.005", theta_deg), mirrored, 2e-3);
  }
  for (const double theta_deg : {0.0, 60.0, 89.0})
    for (const char* rest : {",a=.5", ",eta=1.2,a=.1", ",eta=3,a=.05"})
      EXPECT_LE(albedo(std::string("clear-coat:base=(lambert:kd=1)") + rest, theta_deg), 1 + 1e-3);
}

TEST(ClearCoat, OfIndexOneIsNone) {
  const auto coated = models::make("clear-coat:base=(ward:kd=.5),eta=1").model;
  const auto base = models::make("ward:kd=.5").model;
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const glm::dvec3 l = glm::normalize(upper(random)), v = glm::normalize(upper(random));
    const auto one = in_double(*coated, l, v), other = in_double(*base, l, v);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(one[c], other[c], 1e-9 * std::max(1.0, other[c]));
  }
}

}  // namespace
}  // namespace scanlit
