// Cook-Torrance and Torrance-Sparrow against a second implementation, written from the textbook's
// formulas with angles, tangents and no thought of precision; and what relates the two.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>

#include "models/metals.h"
#include "rasterizer/error.h"
#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;
using std::numbers::pi;

double sqr(double x) { return x * x; }

/// One set of parameters, for the textbook and as a specification.
struct Parameters {
  std::string D, G;
  double x, y;            // D's one or two parameters
  glm::dvec3 eta, k, ks;  // F=conductor
  double kd;

  std::string parts() const {
    const auto rgb = [](const glm::dvec3& c) {
      return text(c.x) + "/" + text(c.y) + "/" + text(c.z);
    };
    const std::string two = D == "ashikhmin-shirley" ? "ex=" + text(x) + ",ey=" + text(y)
                                                     : "ax=" + text(x) + ",ay=" + text(y);
    const std::string one = (D == "blinn" ? "n=" : D == "ggx" ? "a=" : "m=") + text(x);
    const bool brushed = D.find('-') != std::string::npos;
    return "D=" + D + "," + (brushed ? two : one) + ",G=" + G + ",F=conductor,eta=" + rgb(eta) +
           ",k=" + rgb(k) + ",ks=" + rgb(ks) + ",kd=" + text(kd);
  }
};

/// D with the value D(N) taken out.
double shape(const Parameters& p, double alpha, double phi) {
  const double tangent = std::tan(alpha), cosine = std::cos(alpha);
  const double ellipse = sqr(std::cos(phi) / p.x) + sqr(std::sin(phi) / p.y);
  if (p.D == "gaussian") return std::exp(-sqr(alpha / p.x));
  if (p.D == "beckmann") return std::exp(-sqr(tangent / p.x)) / std::pow(cosine, 4);
  if (p.D == "blinn") return std::pow(cosine, p.x);
  if (p.D == "ggx") return sqr(sqr(p.x) / ((sqr(p.x) - 1) * sqr(cosine) + 1));
  if (p.D == "ashikhmin-shirley")
    return std::pow(cosine, p.x * sqr(std::cos(phi)) + p.y * sqr(std::sin(phi)));
  if (p.D == "anisotropic-beckmann") return std::exp(-sqr(tangent) * ellipse) / std::pow(cosine, 4);
  return 1 / sqr(sqr(std::sin(alpha)) * ellipse + sqr(cosine));
}

double at_normal(const Parameters& p) {
  if (p.D == "gaussian") {  // the midpoint rule
    double sum = 0;
    constexpr int steps = 200000;
    const double step = pi / 2 / steps;
    for (int i = 0; i < steps; ++i)
      sum += std::exp(-sqr((i + 0.5) * step / p.x)) * std::sin(2 * (i + 0.5) * step);
    return 1 / (pi * sum * step);
  }
  if (p.D == "blinn") return (p.x + 2) / (2 * pi);
  if (p.D == "ashikhmin-shirley") return std::sqrt((p.x + 2) * (p.y + 2)) / (2 * pi);
  return 1 / (pi * p.x * (p.D == "beckmann" || p.D == "ggx" ? p.x : p.y));
}

double lambda(const Parameters& p, const glm::dvec3& w) {
  double x = p.x, y = p.D.find('-') == std::string::npos ? p.x : p.y;
  if (p.D == "blinn" || p.D == "ashikhmin-shirley")
    x = std::sqrt(2 / (x + 2)), y = std::sqrt(2 / (y + 2));
  const double phi = std::atan2(w.y, w.x), theta = std::acos(w.z);
  const double m = std::sqrt(sqr(x * std::cos(phi)) + sqr(y * std::sin(phi)));
  const double a = 1 / (m * std::tan(theta));
  if (p.D.ends_with("ggx")) return (-1 + std::sqrt(1 + 1 / sqr(a))) / 2;
  return (std::erf(a) - 1) / 2 + std::exp(-sqr(a)) / (2 * a * std::sqrt(pi));
}

double masking(const Parameters& p, const glm::dvec3& l, const glm::dvec3& v, const glm::dvec3& h) {
  if (p.G == "none") return 1;
  const double v_h = glm::dot(v, h);
  if (p.G == "vcavity") return std::min({1.0, 2 * h.z * v.z / v_h, 2 * h.z * l.z / v_h});
  const double to_light = lambda(p, l), to_viewer = lambda(p, v);
  return p.G == "smith" ? 1 / (1 + to_light) / (1 + to_viewer) : 1 / (1 + to_light + to_viewer);
}

/// Fresnel's equations in complex numbers, with Snell's law.
double conductor(double cosine, double eta, double k) {
  const std::complex<double> n(eta, k);
  const std::complex<double> refracted = std::sqrt(1.0 - (1 - sqr(cosine)) / (n * n));
  const auto s = (cosine - n * refracted) / (cosine + n * refracted);
  const auto p = (n * cosine - refracted) / (n * cosine + refracted);
  return (std::norm(s) + std::norm(p)) / 2;
}

/// pi f_r (n.l), its diffuse part aside.
glm::dvec3 textbook(const Parameters& p, const glm::dvec3& l, const glm::dvec3& v) {
  const glm::dvec3 h = glm::normalize(l + v);
  const double alpha = std::acos(h.z), phi = std::atan2(h.y, h.x);
  const double f_r = at_normal(p) * shape(p, alpha, phi) * masking(p, l, v, h) / (4 * l.z * v.z);
  glm::dvec3 fresnel;
  for (int c = 0; c < 3; ++c) fresnel[c] = conductor(glm::dot(v, h), p.eta[c], p.k[c]);
  return p.ks * fresnel * (pi * f_r * l.z);
}

class Microfacets : public testing::TestWithParam<std::string> {
 protected:
  std::mt19937 random{17};

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  glm::dvec3 colour(double low, double high) {
    return {uniform(low, high), uniform(low, high), uniform(low, high)};
  }
  double roughness_or_exponent() {
    const bool exponent = GetParam() == "blinn" || GetParam() == "ashikhmin-shirley";
    return exponent ? std::pow(10, uniform(0, 3)) : uniform(0.1, 1);
  }
  Parameters parameters() {
    const char* masking[] = {"none", "vcavity", "smith", "smith-correlated"};
    const std::string g = masking[random() % 4];
    return {GetParam(),
            g,
            roughness_or_exponent(),
            roughness_or_exponent(),
            colour(0.2, 3),
            colour(0.1, 5),
            colour(0, 1),
            uniform(0, 1)};
  }
  /// Where the textbook's acos keeps its digits.
  glm::dvec3 slanted() { return at(uniform(0.05, 0.95), uniform(-pi, pi)); }
};
INSTANTIATE_TEST_SUITE_P(CookTorrance, Microfacets,
                         testing::Values("gaussian", "beckmann", "blinn", "ggx",
                                         "ashikhmin-shirley", "anisotropic-beckmann",
                                         "anisotropic-ggx"),
                         [](const auto& chosen) {
                           std::string word = chosen.param;
                           std::erase(word, '-');
                           return word;
                         });

TEST_P(Microfacets, AreTheTextbooks) {
  for (int round = 0; round < 40; ++round) {
    const Parameters p = parameters();
    const auto model = models::make("cook-torrance:" + p.parts()).model;
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 l = slanted(), v = slanted();
      const glm::dvec3 expected = textbook(p, l, v);
      const auto value = in_double(*model, l, v);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(value[std::size_t(c)], p.kd * l.z, 1e-15);
        EXPECT_NEAR(value[std::size_t(3 + c)], expected[c], 1e-9 * expected[c] + 1e-15)
            << p.parts();
      }
    }
  }
}

TEST_P(Microfacets, TorranceSparrowIsTheNormalisedForm) {
  for (int round = 0; round < 20; ++round) {
    const std::string parts = parameters().parts();
    const auto one = models::make("cook-torrance:form=normalised," + parts).model;
    const auto other = models::make("torrance-sparrow:" + parts).model;
    EXPECT_EQ(one->needs().frame, other->needs().frame);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 l = slanted(), v = slanted();
      EXPECT_EQ(in_double(*one, l, v), in_double(*other, l, v)) << parts;
    }
  }
}

TEST_P(Microfacets, LectureFormHasDOneAtTheNormal) {
  for (int round = 0; round < 20; ++round) {
    const Parameters p = parameters();
    const auto lecture = models::make("cook-torrance:form=lecture," + p.parts()).model;
    const auto normalised = models::make("cook-torrance:" + p.parts()).model;
    const double factor = pi / 4 * at_normal(p);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 l = slanted(), v = slanted();
      const double value = in_double(*normalised, l, v)[4];
      EXPECT_NEAR(in_double(*lecture, l, v)[4] * factor, value, 1e-9 * value + 1e-200);
    }
    const double head_on = conductor(1, p.eta.x, p.k.x) * p.ks.x;
    EXPECT_NEAR(in_double(*lecture, {0, 0, 1}, {0, 0, 1})[3], head_on, 1e-12) << "D = G = N.V = 1";
  }
}

TEST_P(Microfacets, AreReciprocal) {
  for (int round = 0; round < 20; ++round) {
    const std::string parts = parameters().parts();
    for (const char* form : {"normalised,", "lecture,"}) {
      const auto model = models::make(std::string("cook-torrance:form=") + form + parts).model;
      for (int i = 0; i < 20; ++i) {
        const glm::dvec3 l = slanted(), v = slanted();
        const double value = in_double(*model, l, v)[3] * v.z;
        EXPECT_NEAR(in_double(*model, v, l)[3] * l.z, value, 1e-12 * value) << parts;
      }
    }
  }
}

TEST(CookTorrance, AskForTangentsOnlyIfTheyAreBrushed) {
  for (const std::string d : {"gaussian", "beckmann", "blinn", "ggx"})
    for (const std::string g : {"vcavity", "smith"})
      EXPECT_FALSE(models::make("cook-torrance:D=" + d + ",G=" + g).model->needs().frame) << d;
  for (const std::string d : {"ashikhmin-shirley", "anisotropic-beckmann", "anisotropic-ggx"})
    EXPECT_TRUE(models::make("torrance-sparrow:D=" + d).model->needs().frame) << d;
}

TEST(CookTorrance, MetalsAreTheMetals) {
  const glm::dvec3 n(0, 0, 1), l = at(0.5, 1);
  const double v_h = std::sqrt((1 + 0.5) / 2);
  for (const std::string& name : models::metal_names()) {
    const auto value = in_double(*models::make("cook-torrance:F=" + name).model, l, n);
    const auto mirror = in_double(*models::make("cook-torrance:F=one").model, l, n);
    const Rgb<double> f = models::metal(name)(v_h);
    EXPECT_NEAR(value[3], mirror[3] * f.r, 1e-12) << name;
    EXPECT_NEAR(value[4], mirror[4] * f.g, 1e-12) << name;
    EXPECT_NEAR(value[5], mirror[5] * f.b, 1e-12) << name;
  }
}

TEST(CookTorrance, ParametersThatVaryGiveTheSame) {
  const std::string same = "checker(a=.25,b=.25)";
  for (const std::string specification :
       {"D=gaussian,m=@,F=gold", "D=beckmann,m=@,F=copper,form=lecture",
        "D=ggx,a=@,F=dielectric,G=smith", "D=anisotropic-ggx,ax=@,ay=.5,G=smith-correlated",
        "D=ashikhmin-shirley,ex=@,ey=10,F=schlick,f0=@", "kd=@,D=blinn,n=@,G=smith"}) {
    std::string constant = "cook-torrance:" + specification, varying = constant;
    for (std::size_t i; (i = constant.find('@')) != std::string::npos;)
      constant.replace(i, 1, ".25"), varying.replace(varying.find('@'), 1, same);
    const auto pairs = direction_pairs(200, 5);
    Span span = span_of(pairs);
    const auto one = span.evaluate(*models::make(constant).model);
    const auto other = span.evaluate(*models::make(varying).model);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(one[i][c], other[i][c], 2e-5f * std::abs(one[i][c]) + 1e-6f) << specification;
  }
}

TEST(CookTorrance, ParametersOfAnotherChoiceAreRefused) {
  for (const char* wrong : {"D=ggx,m=.3", "D=beckmann,a=.3", "F=copper,eta=1.5", "f0=.1", "D=cook",
                            "F=coper", "G=smth", "D=beckmann,m=0", "form=paper"})
    EXPECT_THROW(models::make(std::string("cook-torrance:") + wrong), Error) << wrong;
  EXPECT_THROW(models::make("torrance-sparrow:form=lecture"), Error);
}

}  // namespace
}  // namespace scanlit
