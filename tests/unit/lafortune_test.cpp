// Lafortune's model against the paper's formula, against Phong's, and what its text may say.
#include <cmath>
#include <numbers>

#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;
using std::numbers::pi;

TEST(Lafortune, IsThePapersFormula) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coefficient(-1.1, 1.1), exponent(0, 60);
  for (int round = 0; round < 5000; ++round) {
    const glm::dvec3 c[2] = {{coefficient(random), coefficient(random), coefficient(random)},
                             {coefficient(random), coefficient(random), coefficient(random)}};
    const double n[2] = {exponent(random), exponent(random)};
    std::string specification = "lafortune:rd=.2";
    for (int i = 0; i < 2; ++i)
      specification += ",lobe=(cx=" + text(c[i].x) + ",cy=" + text(c[i].y) + ",cz=" + text(c[i].z) +
                       ",n=" + text(n[i]) + ")";
    glm::dvec3 l = direction(random), v = direction(random);
    l.z = std::abs(l.z), v.z = std::max(std::abs(v.z), min_n_v);
    const auto value = in_double(*models::make(specification).model, l, v);
    double f = 0;
    for (int i = 0; i < 2; ++i) f += std::pow(std::max(0.0, glm::dot(c[i], l * v)), n[i]);
    EXPECT_NEAR(value[0], 0.2 * l.z, 1e-15);
    EXPECT_NEAR(value[3], pi * l.z * f, 1e-9 * std::max(1.0, f)) << specification;
  }
}

TEST(Lafortune, PhongsLobeIsOneOfThem) {
  const std::vector<Pair> pairs = direction_pairs(4000, 2);
  for (const std::string n : {"1", "50", "100000"}) {
    const auto lafortune = models::make("lafortune:rd=0,lobe=(cx=-1,cz=1,n=" + n + ")").model;
    const auto phong = models::make("phong:kd=0,ks=1,n=" + n).model;
    for (const auto& [l, v] : pairs) {
      if (v.z < min_n_v || l.z <= 0) continue;
      // The directions are float's: their lengths are 1 to within 1e-7 and not further, and the
      // two forms take that differently.
      const auto unit_l = glm::normalize(glm::dvec3(l)), unit_v = glm::normalize(glm::dvec3(v));
      EXPECT_NEAR(in_double(*lafortune, unit_l, unit_v)[3],
                  pi * unit_l.z * in_double(*phong, unit_l, unit_v)[3], 1e-9);
    }
  }
}

TEST(Lafortune, FloatHoldsForTheSharpestLobes) {
  const std::vector<Pair> pairs = direction_pairs(20000, 3);
  Span span = span_of(pairs);
  for (const char* lobe : {"(cx=-1,cz=1,n=100000)", "(cx=1,cz=1,n=100000)",
                           "(cx=-1.0001,cy=-.9,cz=1,n=20000)", "(cx=.3,cz=1.1,n=100)"}) {
    const auto model = models::make(std::string("lafortune:rd=0,lobe=") + lobe).model;
    const auto batch = span.evaluate(*model);
    double peak = 0;
    for (const auto& [l, v] : pairs) peak = std::max(peak, in_double(*model, l, v)[3]);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double exact = in_double(*model, pairs[i].l, pairs[i].v)[3];
      ASSERT_NEAR(in_float(*model, pairs[i].l, pairs[i].v)[3], exact, 2e-5 * peak) << lobe;
      if (pairs[i].v.z > 0) {
        ASSERT_NEAR(batch[i][3], exact, 2e-5 * peak) << lobe;
      }
    }
  }
}

TEST(Lafortune, ExponentsAndCoefficientsPerChannel) {
  const auto model =
      models::make("lafortune:rd=.3/.4/.7,lobe=(cx=-.5/-.6/-.7,cz=.9/.8/.7,n=1/2/3)").model;
  const glm::dvec3 n(0, 0, 1);
  const auto value = in_double(*model, n, n);
  EXPECT_NEAR(value[2], 0.7, 1e-15);
  EXPECT_NEAR(value[3], pi * 0.9, 1e-12);
  EXPECT_NEAR(value[4], pi * 0.64, 1e-12);
  EXPECT_NEAR(value[5], pi * 0.343, 1e-12);
}

TEST(Lafortune, ALobeOfNoDirectionIsNone) {
  const auto model = models::make("lafortune:rd=0,lobe=(cx=0,cz=0,n=2)").model;
  EXPECT_EQ(in_double(*model, at(0.5, 1), at(0.6, 2))[3], 0);
}

TEST(Lafortune, Refusals) {
  EXPECT_EQ(error_of("lafortune:lobe=3"),
            "model 'lafortune': 'lobe' wants (cx=..,cz=..,n=..), not '3'");
  EXPECT_EQ(error_of("lafortune:lobe=(cx=-1,m=3)"),
            "model 'lafortune', lobe: unknown parameter 'm'; there are: cx, cy, cz, n");
  EXPECT_EQ(error_of("lafortune:lobe=(cx=-1,cx=1)"),
            "model 'lafortune', lobe: 'cx' is given twice");
  EXPECT_EQ(error_of("lafortune:lobe=(n=200000)"),
            "model 'lafortune', lobe: 'n' wants a number from 0 to 100000, not 200000");
  EXPECT_EQ(error_of("lafortune:lobe=(cx=-1.1,cz=1,n=1000)"),
            "model 'lafortune', lobe: max(|cx|, |cy|, |cz|)^n is 1.1^1000 = 2.46993e+41; allowed "
            "is at most 1e+06");
  EXPECT_EQ(error_of("lafortune:lobes=(n=1)"),
            "model 'lafortune': unknown parameter 'lobes'; did you mean 'lobe'?");
}

}  // namespace
}  // namespace scanlit
