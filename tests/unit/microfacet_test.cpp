// The parts of the microfacet models, each alone: D covers the surface, G is what Smith's integral
// says, the furnace finds no energy that was not there.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "models/albedo.h"
#include "models/cook_torrance.h"
#include "tests/unit/batch_lanes.h"
#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;
using std::numbers::pi;

using Model = std::shared_ptr<const ReflectionModel>;
Model make(const std::string& specification) { return models::make(specification).model; }

double red(const ReflectionModel& model, const glm::dvec3& l, const glm::dvec3& v) {
  return in_double(model, l, v)[3];
}

/// D of a part `distribution`: with l = v both are h.
double density(const ReflectionModel& distribution, double alpha, double phi) {
  const glm::dvec3 h(std::sin(alpha) * std::cos(phi), std::sin(alpha) * std::sin(phi),
                     std::cos(alpha));
  return red(distribution, h, h);
}

/// The hemisphere integral of D (N.H), in the logarithm of alpha: as fine at every width. Simpson's
/// rule; over phi, where the integrand is periodic, the trapezoidal.
double covered(const ReflectionModel& distribution, int azimuths) {
  constexpr int steps = 1600;  // even
  const double low = std::log(1e-9), high = std::log(pi / 2), step = (high - low) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {  // at pi/2 cos(alpha) is 0
    const double alpha = std::exp(low + i * step);
    const double weight = i == 0 ? 1 : i % 2 ? 4 : 2;
    for (int j = 0; j < azimuths; ++j)
      sum += weight * density(distribution, alpha, 2 * pi * (j + 0.5) / azimuths) *
             std::cos(alpha) * std::sin(alpha) * alpha;
  }
  return sum * step / 3 * 2 * pi / azimuths;
}

TEST(Microfacet, FacetsCoverTheSurface) {
  std::vector<std::string> specifications;
  for (const char* m : {".001", ".01", ".1", ".3", ".6", "1"}) {
    specifications.push_back(std::string("gaussian,m=") + m);
    specifications.push_back(std::string("beckmann,m=") + m);
    specifications.push_back(std::string("ggx,a=") + m);
  }
  for (const char* n : {"0", "1", "40", "1000", "100000"})
    specifications.push_back(std::string("blinn,n=") + n);
  for (const std::string& d : specifications)
    EXPECT_NEAR(covered(*make("distribution:D=" + d), 1), 1, 1e-7) << d;
}

TEST(Microfacet, BrushedFacetsCoverTheSurface) {
  for (const char* d : {"ashikhmin-shirley,ex=0,ey=100", "ashikhmin-shirley,ex=1000,ey=10",
                        "anisotropic-beckmann,ax=.05,ay=.4", "anisotropic-beckmann,ax=1,ay=.1",
                        "anisotropic-ggx,ax=.05,ay=.4", "anisotropic-ggx,ax=1,ay=.1"})
    EXPECT_NEAR(covered(*make(std::string("distribution:D=") + d), 400), 1, 1e-5) << d;
  for (const char* d : {"ashikhmin-shirley,ex=100000,ey=10", "anisotropic-beckmann,ax=.001,ay=.1",
                        "anisotropic-ggx,ax=.001,ay=.1"})
    EXPECT_NEAR(covered(*make(std::string("distribution:D=") + d), 4000), 1, 1e-5) << d;
}

TEST(Microfacet, GaussianIsNormalised) {
  const double m[] = {.05, .1, .2, .3, .5, .7, 1};
  const double k_pi_m2[] = {1.0017, 1.0067, 1.0270, 1.0615, 1.1780, 1.3703, 1.8259};
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR(models::microfacet::Gaussian<double>(m[i]).peak() * pi * m[i] * m[i], k_pi_m2[i],
                5e-5);
}

/// The integral of exp(-(alpha / m)^2) (N.H) by Simpson's rule, 2 sin cos = sin(2 alpha).
double gaussian_cover(double m) {
  constexpr int steps = 4000;
  const double step = std::min(pi / 2, 9 * m) / steps;
  double sum = 0;
  for (int i = 1; i <= steps; ++i)
    sum += (i == steps ? 1
            : i % 2    ? 4
                       : 2) *
           std::exp(-(i * step / m) * (i * step / m)) * std::sin(2 * i * step);
  return pi * sum * step / 3;
}

TEST(Microfacet, GaussianIsNormalisedTo1e10) {
  for (double m = 1e-3; m <= 1; m *= 1.01) {
    const double k = 1 / gaussian_cover(m);
    EXPECT_NEAR(models::microfacet::Gaussian<double>(m).peak(), k, 1e-10 * k) << m;
    const auto in_batch = lanes_of(models::microfacet::Gaussian<Batch>(Batch(m)).peak());
    const double rounded = 1 / gaussian_cover(double(float(m)));
    EXPECT_NEAR(in_batch[0], rounded, 2e-6 * rounded) << m;
  }
}

TEST(Microfacet, OfEqualWidthsTheAnisotropicIsTheIsotropic) {
  const std::pair<const char*, const char*> twins[] = {
      {"blinn,n=0", "ashikhmin-shirley,ex=0,ey=0"},
      {"blinn,n=300", "ashikhmin-shirley,ex=300,ey=300"},
      {"beckmann,m=.3", "anisotropic-beckmann,ax=.3,ay=.3"},
      {"beckmann,m=.001", "anisotropic-beckmann,ax=.001,ay=.001"},
      {"ggx,a=1", "anisotropic-ggx,ax=1,ay=1"},
      {"ggx,a=.05", "anisotropic-ggx,ax=.05,ay=.05"}};
  for (const auto& [one, other] : twins)
    for (const char* g : {"vcavity", "smith", "smith-correlated"}) {
      const std::string name = std::string("cook-torrance:F=one,G=") + g + ",D=";
      const Model a = make(name + one), b = make(name + other);
      for (const Pair& pair : direction_pairs(2000, 11)) {
        const glm::dvec3 l = glm::normalize(glm::dvec3(pair.l)),
                         v = glm::normalize(glm::dvec3(pair.v));
        if (v.z < min_n_v) continue;  // n_v is raised, the sine that ax scales is not
        const double value = red(*a, l, v);
        EXPECT_NEAR(red(*b, l, v), value, 1e-9 * value + 1e-200) << one << ' ' << g;
      }
    }
}

TEST(Microfacet, BrushedFacetsAreTurnedAlongTheirAxes) {
  // Towards the tangent the width is that of ax or ex, towards the bitangent that of ay or ey.
  const auto ratio = [](const std::string& d, double alpha, double phi) {
    const Model model = make("distribution:D=" + d);
    return density(*model, alpha, phi) / density(*model, 0, 0);
  };
  for (const double alpha : {0.01, 0.1, 0.5}) {
    EXPECT_NEAR(ratio("anisotropic-beckmann,ax=.2,ay=.5", alpha, 0),
                ratio("beckmann,m=.2", alpha, 0), 1e-12);
    EXPECT_NEAR(ratio("anisotropic-beckmann,ax=.2,ay=.5", alpha, pi / 2),
                ratio("beckmann,m=.5", alpha, 0), 1e-12);
    EXPECT_NEAR(ratio("anisotropic-ggx,ax=.2,ay=.5", alpha, 0), ratio("ggx,a=.2", alpha, 0), 1e-12);
    EXPECT_NEAR(ratio("ashikhmin-shirley,ex=50,ey=5", alpha, 0), ratio("blinn,n=50", alpha, 0),
                1e-12);
    EXPECT_NEAR(ratio("ashikhmin-shirley,ex=50,ey=5", alpha, pi / 2), ratio("blinn,n=5", alpha, 0),
                1e-12);
  }
}

/// Smith's Lambda, from its definition: of all slopes x in the direction's azimuth, distributed as
/// p(x), those steeper than mu = cot(theta) hide it: the integral of (x - mu) p(x) over x > mu,
/// divided by mu.
template <class Slopes>
double smith_lambda(double theta, const Slopes& p) {
  const double mu = 1 / std::tan(theta);
  double sum = 0;
  constexpr int steps = 20000;  // the midpoint rule; x - mu = t^3 / (1 - t)^3 reaches infinity
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps, r = t / (1 - t);
    sum += r * r * r * p(mu + r * r * r) * 3 * r * r / ((1 - t) * (1 - t));
  }
  return sum / steps / mu;
}

TEST(Microfacet, LambdaIsSmiths) {
  const auto check = [](const std::string& d, double theta, double phi, double expected) {
    // G with light and viewer in the same direction: Lambda is the same twice.
    const glm::dvec3 w = at(std::cos(theta), phi);
    const double separable = red(*make("masking:G=smith,D=" + d), w, w);
    const double correlated = red(*make("masking:G=smith-correlated,D=" + d), w, w);
    EXPECT_NEAR(separable, 1 / ((1 + expected) * (1 + expected)), 1e-6) << d << ' ' << theta;
    EXPECT_NEAR(correlated, 1 / (1 + 2 * expected), 1e-6) << d << ' ' << theta;
  };
  for (const double theta : {0.1, 0.5, 1.0, 1.4, 1.55})
    for (const double m : {0.1, 0.4, 1.0}) {
      const auto normal = [&](double x) {
        return std::exp(-x * x / (m * m)) / (m * std::sqrt(pi));
      };
      const auto ggx = [&](double x) { return m * m / (2 * std::pow(m * m + x * x, 1.5)); };
      const double beckmann = smith_lambda(theta, normal);
      check("beckmann,m=" + text(m), theta, 1, beckmann);
      check("ggx,a=" + text(m), theta, 1, smith_lambda(theta, ggx));
      check("gaussian,m=" + text(m), theta, 1, beckmann);
      check("anisotropic-beckmann,ay=.02,ax=" + text(m), theta, 0, beckmann);
      check("anisotropic-ggx,ax=.02,ay=" + text(m), theta, pi / 2, smith_lambda(theta, ggx));
      // The roughness in a direction between.
      const double between = std::sqrt(0.5 * (m * m + 0.2 * 0.2));
      const auto slopes = [&](double x) {
        return between * between / (2 * std::pow(between * between + x * x, 1.5));
      };
      check("anisotropic-ggx,ax=.2,ay=" + text(m), theta, pi / 4, smith_lambda(theta, slopes));
    }
  for (const double n : {0.0, 8.0, 198.0}) {
    const double m = std::sqrt(2 / (n + 2));
    const auto normal = [&](double x) { return std::exp(-x * x / (m * m)) / (m * std::sqrt(pi)); };
    check("blinn,n=" + text(n), 1.3, 1, smith_lambda(1.3, normal));
    check("ashikhmin-shirley,ex=1000,ey=" + text(n), 1.3, pi / 2, smith_lambda(1.3, normal));
  }
}

TEST(Microfacet, MaskingOfLightAndViewer) {
  const glm::dvec3 l = at(std::cos(1.2), 0), v = at(std::cos(0.7), 2);
  const auto ggx = [](double theta) {
    return (std::sqrt(1 + 0.25 * std::tan(theta) * std::tan(theta)) - 1) / 2;
  };
  EXPECT_NEAR(red(*make("masking:G=smith,D=ggx,a=.5"), l, v), 1 / ((1 + ggx(1.2)) * (1 + ggx(.7))),
              1e-12);
  EXPECT_NEAR(red(*make("masking:G=smith-correlated,D=ggx,a=.5"), l, v),
              1 / (1 + ggx(1.2) + ggx(.7)), 1e-12);
  EXPECT_EQ(red(*make("masking:G=none"), l, v), 1);
  const glm::dvec3 h = glm::normalize(l + v);
  EXPECT_NEAR(red(*make("masking:G=vcavity"), l, v), 2 * h.z * l.z / glm::dot(v, h), 1e-12);
  EXPECT_EQ(red(*make("masking:G=vcavity"), at(0.9, 0), at(0.8, 2)), 1) << "nothing is hidden";
}

TEST(Microfacet, ErrorFunctionInBatch) {
  double largest = 0;
  for (int i = 0; i <= 100000; ++i) {
    const float x = float(i) * 1e-4f;
    largest = std::max(largest, std::abs(lanes_of(erfc(Batch(x)))[0] - std::erfc(double(x))));
  }
  EXPECT_LT(largest, 6e-7);
  EXPECT_EQ(lanes_of(erfc(Batch(1e12f)))[0], 0);
}

double albedo(const std::string& specification, double theta_deg) {
  const glm::dvec3 v = at(std::cos(theta_deg * pi / 180), 0.3);
  return models::directional_albedo(*make(specification), {v.x, v.y, v.z}, 1e-5).value.r;
}

TEST(Microfacet, FurnaceTable) {
  const double theta_deg[] = {0, 30, 60, 75, 85, 89};
  const struct {
    const char* parts;
    double expected[6];
  } rows[] = {{"D=beckmann,m=.2,G=vcavity", {1.0000, .9989, .9656, .9275, .9598, .9914}},
              {"D=beckmann,m=.5,G=vcavity", {.8924, .8750, .8869, .9344, .9772, .9954}},
              {"D=gaussian,m=.5,G=vcavity", {.8619, .8562, .8828, .9303, .9754, .9950}},
              {"D=ggx,a=.5,G=smith", {.6878, .6816, .6860, .7234, .7772, .8065}},
              {"D=ggx,a=.5,G=smith-correlated", {.6878, .6831, .6983, .7614, .8720, .9602}}};
  for (const auto& row : rows)
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(albedo(std::string("cook-torrance:F=one,") + row.parts, theta_deg[i]),
                  row.expected[i], 5e-4)
          << row.parts << " at " << theta_deg[i];
  EXPECT_NEAR(albedo("cook-torrance:F=one,D=beckmann,m=.2,G=none", 85), 1.235, 2e-3);
  EXPECT_NEAR(albedo("cook-torrance:F=one,D=beckmann,m=.2,G=none", 89), 3.75, 5e-3);
}

TEST(Microfacet, CreatesNoLightWhereItSaysSo) {
  std::vector<std::string> parts;
  for (const char* g : {"vcavity", "smith", "smith-correlated"})
    for (const char* d : {"beckmann,m=.05", "beckmann,m=.3", "beckmann,m=1", "ggx,a=.05", "ggx,a=1",
                          "anisotropic-beckmann,ax=.1,ay=.5", "anisotropic-ggx,ax=1,ay=.1"})
      parts.push_back(std::string(g) + ",D=" + d);
  for (const char* d : {"gaussian,m=.05", "gaussian,m=1", "blinn,n=0", "blinn,n=1000",
                        "ashikhmin-shirley,ex=0,ey=100", "ashikhmin-shirley,ex=1000,ey=1"})
    parts.push_back(std::string("vcavity,D=") + d);
  for (const std::string& g : parts)
    for (const double theta_deg : {0., 40., 70., 84., 89.})
      EXPECT_LE(albedo("cook-torrance:F=one,G=" + g, theta_deg), 1 + 2e-5) << g << ' ' << theta_deg;
}

TEST(Microfacet, AStandInForLambdaHidesTooLittleAtGrazing) {
  const auto broad = [](const char* d) {
    return albedo(std::string("cook-torrance:F=one,G=smith-correlated,D=") + d, 89.8);
  };
  EXPECT_NEAR(broad("blinn,n=0"), 1.74, 0.005);
  EXPECT_NEAR(broad("blinn,n=20"), 1.03, 0.005);
  EXPECT_NEAR(broad("blinn,n=100"), 1.002, 5e-4);
  EXPECT_NEAR(broad("gaussian,m=1"), 1.06, 0.005);
  EXPECT_NEAR(broad("gaussian,m=.3"), 1.01, 0.005);
}

TEST(Microfacet, FresnelByName) {
  const glm::dvec3 l = at(0.1, 0), v = at(0.3, pi);
  const double c = std::sqrt((1 + glm::dot(l, v)) / 2);
  const auto fresnel = [&](const std::string& f) {
    const auto value = in_double(*make("fresnel:F=" + f), l, v);
    return Rgb<double>(value[3], value[4], value[5]);
  };
  const auto expect_equal = [](const Rgb<double>& a, const Rgb<double>& b) {
    EXPECT_NEAR(a.r, b.r, 1e-12);
    EXPECT_NEAR(a.g, b.g, 1e-12);
    EXPECT_NEAR(a.b, b.b, 1e-12);
  };
  for (const std::string& name : models::metal_names())
    expect_equal(fresnel(name), models::metal(name)(c));
  expect_equal(fresnel("one"), Rgb<double>(1.0));
  expect_equal(fresnel("schlick,f0=.1/.2/.3"),
               models::SchlickFresnel<double>{.f0 = {.1, .2, .3}}(c));
  expect_equal(fresnel("dielectric,eta=1.33"),
               models::DielectricFresnel<double>{Rgb<double>(1.33)}(c));
  expect_equal(fresnel("conductor,eta=.2/.9/1.1,k=3.9/2.4/2.2"),
               models::ConductorFresnel<double>{{.2, .9, 1.1}, {3.9, 2.4, 2.2}}(c));
}

}  // namespace
}  // namespace scanlit
