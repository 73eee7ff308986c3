// Fresnel reflectance: against Fresnel's equations in complex arithmetic, and at its limits.
#include "models/fresnel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "models/conductor_fit.h"
#include "models/microfacet/fresnel_choice.h"
#include "tests/unit/batch_lanes.h"

namespace scanlit::models {
namespace {

using namespace test;

float first_lane(Batch b) { return lanes_of(b)[0]; }

/// Both polarisations, as textbooks print them.
double textbook(double c, double eta, double k) {
  using Complex = std::complex<long double>;
  const Complex n(eta, k), q = std::sqrt(n * n - 1.0L + Complex(c) * Complex(c)), ci(c);
  const Complex s = (ci - q) / (ci + q), p = (n * n * ci - q) / (n * n * ci + q);
  return double(0.5L * (std::norm(s) + std::norm(p)));
}

/// Angles of incidence from normal to grazing, close to both ends too. Floats.
float any_cosine(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  switch (random() % 4) {
    case 0: return float(std::exp2(-30 * unit(random)));
    case 1: return float(1 - 1e-5 * unit(random));
    default: return float(unit(random));
  }
}

TEST(ConductorReflectance, IsFresnelsEquationsInAllPrecisions) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst_double = 0, worst_float = 0, worst_batch = 0;
  for (int round = 0; round < 200000; ++round) {
    const float c = any_cosine(random);
    // Metals; anything; almost no surface at all.
    auto eta = float(0.02 + 6 * unit(random)), k = float(10 * unit(random));
    if (round % 3 == 1)
      eta = float(std::exp2(-6 + 26 * unit(random))), k = float(std::exp2(-10 + 30 * unit(random)));
    if (round % 3 == 2) eta = float(1 + 1e-3 * unit(random)), k = float(1e-3 * unit(random));
    if (eta < 1 && eta * k < 0.01f) continue;
    const double exact = textbook(c, eta, k);
    const auto worsen = [&](double& worst, double value) {
      worst = std::max(worst, or_infinity(std::abs(value - exact)));
    };
    worsen(worst_double, conductor_reflectance<double>(c, eta, k));
    worsen(worst_float, conductor_reflectance(c, eta, k));
    worsen(worst_batch, first_lane(conductor_reflectance<Batch>(c, eta, k)));
  }
  EXPECT_LE(worst_double, 1e-14);
  EXPECT_LE(worst_float, 1e-6);
  EXPECT_LE(worst_batch, 1e-6);
}

TEST(DielectricReflectance, IsFresnelsEquationsInAllPrecisions) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst_double = 0, worst_float = 0, worst_batch = 0, worst_share = 0;
  for (int round = 0; round < 200000; ++round) {
    const float c = any_cosine(random);
    auto eta = float(0.02 + 3 * unit(random));
    if (round % 3 == 1) eta = float(1 + 1e-3 * (unit(random) - 0.5));
    if (round % 3 == 2) eta = float(std::exp2(20 * unit(random)));
    const double to_critical = double(c) * c - (1 - double(eta) * eta);
    if (eta == 1 || (eta < 1 && std::abs(to_critical) < 0.01)) continue;
    const double exact = eta < 1 && to_critical < 0 ? 1 : textbook(c, eta, 0);
    const auto worsen = [&](double& worst, double value) {
      worst = std::max(worst, or_infinity(std::abs(value - exact)));
    };
    worsen(worst_double, dielectric_reflectance<double>(c, eta));
    worsen(worst_float, dielectric_reflectance(c, eta));
    worsen(worst_batch, first_lane(dielectric_reflectance<Batch>(c, eta)));
    worst_share =
        std::max(worst_share, or_infinity(std::abs(dielectric_reflectance(c, eta) / exact - 1)));
    worsen(worst_double, conductor_reflectance<double>(c, eta, 0));
    worsen(worst_float, conductor_reflectance(c, eta, 0.0f));
  }
  EXPECT_LE(worst_double, 1e-12);
  EXPECT_LE(worst_float, 2e-6);
  EXPECT_LE(worst_batch, 2e-6);
  EXPECT_LE(worst_share, 2e-5) << "of F: a narrow lobe magnifies a small one";
}

TEST(Fresnel, AtNormalAndGrazingIncidence) {
  for (const double eta : {0.05, 0.5, 1.0, 1.2, 1.5, 3.0, 40.0})
    for (const double k : {0.0, 0.1, 2.0, 7.0, 100.0}) {
      const double f0 = ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
      EXPECT_NEAR(conductor_reflectance(1.0, eta, k), f0, 1e-14) << eta << ' ' << k;
      EXPECT_EQ(conductor_reflectance(0.0, eta, k), 1) << eta << ' ' << k;
      EXPECT_EQ(conductor_reflectance(0.0f, float(eta), float(k)), 1) << eta << ' ' << k;
      EXPECT_EQ(first_lane(conductor_reflectance<Batch>(0, eta, k)), 1) << eta << ' ' << k;
    }
  EXPECT_NEAR(dielectric_reflectance(1.0, 1.5), 0.04, 1e-15);
  EXPECT_EQ(dielectric_reflectance(0.0, 1.5), 1);
  EXPECT_NEAR(dielectric_reflectance(std::cos(std::atan(1.5)), 1.5),
              0.5 * std::pow(std::cos(2 * std::atan(1.5)), 2), 1e-15)
      << "at Brewster's angle only the s polarisation is reflected";
}

TEST(Fresnel, WithinTheDenserMediumReflectionIsTotalBeyondTheCriticalAngle) {
  const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
  for (const double c : {0.0, 1e-9, 0.1, 0.5, critical - 1e-9})
    EXPECT_EQ(dielectric_reflectance(c, 1 / 1.5), 1) << c;
  EXPECT_LT(dielectric_reflectance(critical + 0.01, 1 / 1.5), 0.6);
  EXPECT_NEAR(dielectric_reflectance(1.0, 1 / 1.5), 0.04, 1e-15);
}

TEST(Fresnel, WhereThereIsNoSurfaceNothingIsReflectedButAtGrazing) {
  for (const double c : {1e-8, 1e-3, 0.5, 1.0}) {
    EXPECT_NEAR(dielectric_reflectance(c, 1.0), 0, 1e-6) << c;
    EXPECT_NEAR(conductor_reflectance(c, 1.0, 0.0), 0, 1e-6) << c;
    EXPECT_NEAR(dielectric_reflectance(float(c), 1.0f), 0, 1e-6) << c;
    EXPECT_NEAR(conductor_reflectance(float(c), 1.0f, 0.0f), 0, 1e-6) << c;
  }
  EXPECT_EQ(dielectric_reflectance(0.0f, 1.0f), 1);
  EXPECT_EQ(conductor_reflectance(0.0f, 1.0f, 0.0f), 1);
}

TEST(Fresnel, IsWithin0And1ForEveryParameterInAllPrecisions) {
  const auto in_range = [](double f) { return f >= 0 && f <= 1; };
  for (const float c : {0.0f, 1e-38f, 1e-20f, 1e-7f, 0.3f, 0.5f, 0.99999994f, 1.0f})
    for (const float eta : {1e-3f, 0.5f, 0.99999994f, 1.0f, 1.0000001f, 1.5f, 1e3f, 1e6f})
      for (const float k : {0.0f, 1e-38f, 1e-7f, 1.0f, 1e3f, 1e6f}) {
        SCOPED_TRACE(testing::Message() << "c " << c << " eta " << eta << " k " << k);
        EXPECT_PRED1(in_range, conductor_reflectance<double>(c, eta, k));
        EXPECT_PRED1(in_range, conductor_reflectance(c, eta, k));
        EXPECT_PRED1(in_range, first_lane(conductor_reflectance<Batch>(c, eta, k)));
        EXPECT_PRED1(in_range, dielectric_reflectance<double>(c, eta));
        EXPECT_PRED1(in_range, dielectric_reflectance(c, eta));
        EXPECT_PRED1(in_range, first_lane(dielectric_reflectance<Batch>(c, eta)));
      }
}

// ---------------------------------------------------------------------------- fitted conductors

TEST(ConductorFit, OfMostMetalsIsWithinItsTolerance) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst_double = 0, worst_float = 0, worst_batch = 0;
  int close = 0;
  constexpr int metals = 2000;
  for (int round = 0; round < metals; ++round) {
    const double eta = 0.02 + 6 * unit(random), k = 10 * unit(random);
    const ConductorFit fit{Rgb<double>(eta), Rgb<double>(k)};
    close += fit.close();
    for (int i = 0; i < 50 && fit.close(); ++i) {
      const float c = any_cosine(random);
      const double exact = textbook(c, eta, k);
      const auto worsen = [&](double& worst, double value) {
        worst = std::max(worst, or_infinity(std::abs(value - exact)));
      };
      worsen(worst_double, fit(double(c)).r);
      worsen(worst_float, fit(c).g);
      worsen(worst_batch, first_lane(fit(Batch(c)).b));
    }
  }
  EXPECT_GE(close, 0.97 * metals);
  EXPECT_LE(worst_double, 1.01 * ConductorFit::tolerance);
  EXPECT_LE(worst_float, 2 * ConductorFit::tolerance);
  EXPECT_LE(worst_batch, 2 * ConductorFit::tolerance);
}

TEST(ConductorFit, IsNotTakenWhereItWouldBeOff) {
  const auto close = [](double eta, double k) {
    return ConductorFit({1.5, eta, 1.5}, {7.62, k, 7.62}).close();
  };
  EXPECT_TRUE(close(1.5, 7.62));
  EXPECT_TRUE(close(0.05, 3));
  EXPECT_FALSE(close(1 / 1.5, 0)) << "total reflection";
  EXPECT_FALSE(close(0.2, 0.01));
  EXPECT_FALSE(close(1, 0)) << "no surface";
  EXPECT_FALSE(ConductorFit().close()) << "nothing is fitted yet";
}

TEST(ConductorFit, IsWhatAModelDrawsButNotWhatItIsInDouble) {
  microfacet::Fresnel<> model;
  model.fresnel = microfacet::Fresnel<>::conductor;
  model.eta = {0.3, 1.0, 1.2}, model.extinction = {3.2, 2.6, 2.4};
  model.prepare();
  const ConductorFresnel<> exact{.eta = model.eta, .k = model.extinction};
  EXPECT_EQ(model.F(0.5), exact(0.5));
  EXPECT_EQ(model.F(0.5f), ConductorFit(model.eta, model.extinction)(0.5f));
  model.eta.g = 1, model.extinction.g = 1e-3;
  model.prepare();
  EXPECT_EQ(model.F(0.5f), (ConductorFresnel<>{model.eta, model.extinction}(0.5f)));
}

TEST(FresnelClasses, GiveEachChannelItsOwn) {
  const ConductorFresnel<> copper_like{.eta = {0.3, 1.0, 1.2}, .k = {3.2, 2.6, 2.4}};
  const Rgb<float> f = copper_like(0.5f);
  EXPECT_EQ(f.r, conductor_reflectance(0.5f, 0.3f, 3.2f));
  EXPECT_EQ(f.g, conductor_reflectance(0.5f, 1.0f, 2.6f));
  EXPECT_EQ(f.b, conductor_reflectance(0.5f, 1.2f, 2.4f));
  EXPECT_EQ(DielectricFresnel<>{.eta = Rgb<double>(2.0)}(0.5).g, dielectric_reflectance(0.5, 2.0));
  EXPECT_EQ(UnitFresnel{}(0.5f), Rgb<float>(1.0f));

  const SchlickFresnel<> schlick{.f0 = {0.1, 0.5, 1.0}};
  EXPECT_EQ(schlick(1.0), Rgb<double>(0.1, 0.5, 1.0));
  EXPECT_EQ(schlick(0.0), Rgb<double>(1.0));
  EXPECT_NEAR(schlick(0.5).r, 0.1 + 0.9 / 32, 1e-15);
}

TEST(FresnelClasses, TakeParametersThatVary) {
  Lanes eta, cosine;
  for (std::size_t i = 0; i < eta.size(); ++i) eta[i] = 1 + float(i), cosine[i] = 0.2f;
  const DielectricFresnel<Batch> varying{.eta = Rgb<Batch>(Batch::load(eta.data()))};
  const Lanes f = lanes_of(varying(Batch::load(cosine.data())).r);
  for (std::size_t i = 0; i < f.size(); ++i)
    EXPECT_NEAR(f[i], dielectric_reflectance<double>(cosine[i], eta[i]), 2e-6);
}

TEST(Schlick, IsCloseToAnExactDielectric) {
  const SchlickFresnel<> schlick{.f0 = Rgb<double>(0.04)};
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double c = i / 1000.0;
    worst = std::max(worst, std::abs(schlick(c).r - dielectric_reflectance(c, 1.5)));
  }
  EXPECT_LT(worst, 0.05);
}

}  // namespace
}  // namespace scanlit::models
