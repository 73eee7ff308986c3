// MERL tables: angles, look-ups, files.
#include <limits>
#include <numbers>

#include "tests/unit/measured_tables.h"

namespace scanlit {
namespace {

using namespace test;
using namespace models;

constexpr double pi = std::numbers::pi;

/// The table of Chiral, made when it is first asked for, in its file until the process ends.
class MerlTest : public MeasuredTest {
 protected:
  static fs::path chiral() {
    static const fs::path file = [] {
      tabulate_merl(model_of<Chiral>(), in_folder("chiral.binary"));
      return in_folder("chiral.binary");
    }();
    return file;
  }
  static const MerlTable& table() {
    static const MerlTable read = read_merl(chiral());
    return read;
  }
  static const Merl& nearest() {
    static const Merl model(table(), MerlLookup::nearest);
    return model;
  }
  static const Merl& trilinear() {
    static const Merl model(table());
    return model;
  }
};

/// The paper's definition: L turned by -phi_h about z, then by -theta_h about y.
HalfDifference<double> by_turning(const Vec3<double>& l, const Vec3<double>& v) {
  const glm::dvec3 h = glm::normalize(glm::dvec3(l.x + v.x, l.y + v.y, l.z + v.z));
  const double theta = std::acos(h.z), phi = std::atan2(h.y, h.x);
  const double x = l.x * std::cos(phi) + l.y * std::sin(phi);
  const double y = l.y * std::cos(phi) - l.x * std::sin(phi);
  const glm::dvec3 d(x * std::cos(theta) - l.z * std::sin(theta), y,
                     x * std::sin(theta) + l.z * std::cos(theta));
  return {theta, std::acos(std::min(d.z, 1.0)), std::atan2(d.y, d.x)};
}

TEST(HalfDifferenceAngles, AreThePapersAndLeadBack) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 a = direction(random), b = direction(random);
    const Vec3<double> n{0, 0, 1}, l{a.x, a.y, std::abs(a.z)}, v{b.x, b.y, std::abs(b.z)};
    const auto angles = half_difference(n, l, v), expected = by_turning(l, v);
    EXPECT_NEAR(angles.theta_h, expected.theta_h, 1e-7);
    EXPECT_NEAR(angles.theta_d, expected.theta_d, 1e-7);
    EXPECT_NEAR(std::remainder(angles.phi_d - expected.phi_d, 2 * pi), 0, 1e-6);
    const auto back = directions(angles, std::atan2(l.y + v.y, l.x + v.x));
    EXPECT_NEAR(dot(back.l, l), 1, 1e-12);
    EXPECT_NEAR(dot(back.v, v), 1, 1e-12);
  }
}

TEST(HalfDifferenceAngles, KeepTheirDigitsNearTheHighlightAndAtRetroreflection) {
  for (const double tiny : {1e-3, 1e-4, 1e-5})
    for (const HalfDifference<double> angles :
         {HalfDifference<double>{tiny, 0.7, 0.5}, HalfDifference<double>{0.7, tiny, 0.5}}) {
      const auto [l, v] = directions(angles);
      const Vec3<float> n{0, 0, 1}, lf{float(l.x), float(l.y), float(l.z)},
          vf{float(v.x), float(v.y), float(v.z)};
      const auto in_float = half_difference(n, lf, vf);
      EXPECT_NEAR(in_float.theta_h, angles.theta_h, 1.5e-7);
      EXPECT_NEAR(in_float.theta_d, angles.theta_d, 1.5e-7);
    }
}

TEST_F(MerlTest, BothLookUpsAreExactAtTheCentresOfBins) {
  const auto source = model_of<Chiral>();
  std::mt19937 random(2);
  int measured = 0;
  for (int i = 0; i < 20000; ++i) {
    const int h = int(random() % 90), d = int(random() % 90), p = int(random() % 180);
    const auto [l, v] = directions(MerlTable::centre(h, d, p), double(random()));
    if (l.z < min_n_v || v.z < min_n_v) continue;
    ++measured;
    const Rgb<double> expected = whole(source, l, v);
    EXPECT_LT(distance(whole(nearest(), l, v), expected), 1e-12) << h << ' ' << d << ' ' << p;
    EXPECT_LT(distance(whole(trilinear(), l, v), expected), 1e-9) << h << ' ' << d << ' ' << p;
    EXPECT_LT(distance(whole(nearest(), v, l) * (l.z / v.z), expected), 1e-12) << "reciprocal";
  }
  EXPECT_GT(measured, 8000);
}

TEST_F(MerlTest, BetweenTheCentresTrilinearIsNearerThanNearest) {
  const auto source = model_of<Chiral>();
  std::mt19937 random(3);
  double nearest_error = 0, trilinear_error = 0, worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 a = direction(random), b = direction(random);
    const Vec3<double> l{a.x, a.y, std::abs(a.z)}, v{b.x, b.y, std::abs(b.z)};
    if (l.z < 0.1 || v.z < 0.1) continue;  // where bins below the horizon are among the eight
    const Rgb<double> expected = whole(source, l, v);
    nearest_error += std::pow(distance(whole(nearest(), l, v), expected), 2);
    trilinear_error += std::pow(distance(whole(trilinear(), l, v), expected), 2);
    worst = std::max(worst, distance(whole(trilinear(), l, v), expected));
  }
  EXPECT_LT(worst, 3e-4);
  EXPECT_GT(std::sqrt(nearest_error / trilinear_error), 50);
}

TEST_F(MerlTest, ARoughWayAroundTheHorizonIsKept) {
  // Where some of the eight bins were not measured, the others stand for them.
  const auto source = model_of<Chiral>();
  for (double degrees = 80; degrees < 89; degrees += 0.37)
    for (double phi = 0; phi < 6.3; phi += 0.31) {
      const double t = degrees * pi / 180;
      const Vec3<double> l{std::sin(t), 0, std::cos(t)};
      const Vec3<double> v{0.6 * std::cos(phi), 0.6 * std::sin(phi), 0.8};
      EXPECT_LT(distance(whole(trilinear(), l, v), whole(source, l, v)), 0.05 * l.z) << degrees;
    }
}

TEST_F(MerlTest, IsSoundEverywhereInAllPrecisions) {
  const auto bins = [](const Pair& pair) {
    const auto a = half_difference<double>({0, 0, 1}, {pair.l.x, pair.l.y, pair.l.z},
                                           {pair.v.x, pair.v.y, pair.v.z});
    return std::array{90 * std::sqrt(a.theta_h * 2 / pi), a.theta_d * 180 / pi, a.phi_d * 180 / pi};
  };
  expect_sound(nearest(), [&](const Pair& pair) {
    for (const double bin : bins(pair))
      if (std::abs(bin - std::round(bin)) < 2e-3) return false;
    return true;
  });
  expect_sound(trilinear(), [&](const Pair& pair) {
    // Nearer to the horizon bins come and go that were not measured.
    return std::min(pair.l.z, pair.v.z) > 0.1;
  });
}

TEST_F(MerlTest, SpansInAnySpaceAgreeWithQueriesAndNeedNoTangent) {
  EXPECT_FALSE(trilinear().needs().frame);
  std::mt19937 random(4);
  Span span = random_span(1001, random);
  const auto batch = span.evaluate(trilinear());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const glm::dvec3 n = span.get(i, Span::normal), t = span.get(i, Span::tangent);
    const auto local = [&](int which) {
      const glm::dvec3 d = span.get(i, which);
      return glm::dvec3(glm::dot(d, t), glm::dot(d, glm::cross(n, t)), glm::dot(d, n));
    };
    const glm::dvec3 l = local(Span::to_light), v = local(Span::to_viewer);
    if (l.z < 0.05 || v.z < 0.05) continue;
    const auto expected = in_double(trilinear(), l, v);
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(batch[i][c], expected[c], 1e-5) << i;
  }
}

TEST_F(MerlTest, AViewerBelowTheHorizonIsTakenForOneJustAboveInSpans) {
  const glm::vec3 l(0.6f, 0, 0.8f);
  const std::vector<Pair> pairs = {{l, glm::normalize(glm::vec3(-1, 0, 1e-4f))},
                                   {l, glm::normalize(glm::vec3(-1, 0, -0.2f))}};
  const auto batch = span_of(pairs).evaluate(trilinear());
  EXPECT_GT(batch[0][3], 0.1f);
  EXPECT_NEAR(batch[1][3], batch[0][3], 1e-3);
  EXPECT_EQ(in_float(trilinear(), pairs[1].l, pairs[1].v)[3], 0);
}

TEST_F(MerlTest, WhatWasNotMeasuredIsBlackOrLeftOut) {
  MerlTable table = MerlTest::table();
  const auto& at = table.entries[MerlTable::index(30, 20, 60)];
  const auto [l, v] = directions(MerlTable::centre(30, 20, 60));
  const Rgb<double> before = whole(trilinear(), l, v);
  table.entries[MerlTable::index(30, 20, 60)] = {at.r, -1e-9, at.b};  // one channel is enough
  EXPECT_EQ(whole(Merl(table, MerlLookup::nearest), l, v), Rgb<double>(0.0));
  const auto [l2, v2] = directions({MerlTable::centre(30, 20, 60).theta_h + 1e-4,
                                    MerlTable::centre(30, 20, 60).theta_d + 1e-3,
                                    MerlTable::centre(30, 20, 60).phi_d + 1e-3});
  EXPECT_LT(distance(whole(Merl(table), l2, v2), before), 0.02) << "its neighbours stand for it";
  for (auto& entry : table.entries) entry = Rgb<double>(-1.0);
  table.entries[MerlTable::index(31, 20, 60)] = Rgb<double>(1500.0);
  const Vec3<float> lf{float(l.x), float(l.y), float(l.z)}, vf{float(v.x), float(v.y), float(v.z)};
  EXPECT_EQ(whole(Merl(table), l, v), Rgb<double>(0.0)) << "a neighbour without a share";
  EXPECT_EQ(Merl(table).evaluate(lf, vf).glossy, Rgb<float>(0.0f));
  table.entries[MerlTable::index(31, 20, 60)] = Rgb<double>(-1.0);
  EXPECT_EQ(whole(Merl(table), l, v), Rgb<double>(0.0)) << "nobody stands for it";
}

TEST_F(MerlTest, ScalesAndFoldAreThePublishedOnes) {
  // An entry of 1500 in one bin: f_r there is 1, 1.15, 1.66.
  MerlTable table{std::vector<Rgb<double>>(MerlTable::size)};
  table.entries[MerlTable::index(45, 30, 135)] = Rgb<double>(1500.0);
  const Merl merl(std::move(table), MerlLookup::nearest);
  for (const double fold : {0.0, -pi}) {
    const auto [l, v] = directions({pi / 2 * 0.2551, 30.5 * pi / 180, 135.5 * pi / 180 + fold});
    const Rgb<double> f_r = whole(merl, l, v) * (1 / (pi * l.z));
    EXPECT_LT(distance(f_r, {1, 1.15, 1.66}), 1e-12);
  }
}

TEST_F(MerlTest, ReadThenWrittenTheBytesAreTheSame) {
  const fs::path first = in_folder("first.binary"), second = in_folder("second.binary");
  fs::copy_file(chiral(), first);
  patch(first, 12 + 8 * 4711, -3.25);
  patch(first, 12 + 8 * 4712, -0.0);
  write_merl(read_merl(first), second);
  EXPECT_TRUE(bytes_of(first) == bytes_of(second));
  fs::remove(first), fs::remove(second);
}

TEST_F(MerlTest, IsMadeFromWords) {
  const auto [l, v] = directions({0.3, 0.4, 0.5});
  const std::string words = "merl:file=" + chiral().filename().string();
  EXPECT_EQ(whole(*make(words, folder()).model, l, v), whole(trilinear(), l, v));
  EXPECT_EQ(whole(*make(words + ",lookup=nearest", folder()).model, l, v), whole(nearest(), l, v));
  EXPECT_EQ(refusal(in_folder("x"), [](const fs::path&) { make("merl:file=x", folder()); }),
            "there is no such file");
  EXPECT_EQ(refusal("model 'merl'", [](const fs::path&) { make("merl"); }),
            "'file' must be given: a table of 90 90 180 bins, as published: x.binary");
}

TEST_F(MerlTest, RefusesFilesThatAreNone) {
  const auto of = [](const fs::path& file) { return refusal(file, read_merl); };
  EXPECT_EQ(of(in_folder("none")), "there is no such file");
  EXPECT_EQ(of(folder()), "is a folder, not a table");
  EXPECT_EQ(of("/dev/zero"), "is not a regular file");
  const std::string wanted = "; a MERL table has 90 90 180 bins, 34992012 bytes in all";
  EXPECT_EQ(of(written("t", "")), "the file ends before its dimensions" + wanted);
  EXPECT_EQ(of(written("t", "BRDF 90 90")), "the file ends before its dimensions" + wanted);
  const auto dimensions = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    std::string bytes(12 + 80, '\0');
    const std::int32_t all[] = {a, b, c};
    std::memcpy(bytes.data(), all, sizeof all);
    return of(written("t", bytes));
  };
  EXPECT_EQ(dimensions(90, 90, 180), "the file is 92 bytes long" + wanted);
  EXPECT_EQ(dimensions(90, 90, 360), "the dimensions are 90 90 360" + wanted);
  EXPECT_EQ(dimensions(180, 90, 90), "the dimensions are 180 90 90" + wanted) << "equal product";
  EXPECT_EQ(dimensions(-90, -90, 180), "the dimensions are -90 -90 180" + wanted);
  EXPECT_EQ(dimensions(2147483647, 2147483647, 2147483647),
            "the dimensions are 2147483647 2147483647 2147483647" + wanted);
}

TEST_F(MerlTest, RefusesLengthsAndNumbersThatCannotBe) {
  const auto of = [](const fs::path& file) { return refusal(file, read_merl); };
  const fs::path file = in_folder("bad.binary");
  fs::copy_file(chiral(), file);
  const std::string wanted = "; a MERL table has 90 90 180 bins, 34992012 bytes in all";
  for (const auto size : {34992011u, 34992013u}) {
    fs::resize_file(file, size);
    EXPECT_EQ(of(file), "the file is " + std::to_string(size) + " bytes long" + wanted);
  }
  fs::resize_file(file, 34992012);
  patch(file, 12 + 8 * (MerlTable::size + 5), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(of(file),
            "green entry 5 (counted from 0; at byte 11664052) is nan; entries are finite and "
            "within +-1e+30");
  patch(file, 12, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(of(file).substr(0, 45), "red entry 0 (counted from 0; at byte 12) is -");
  patch(file, 12, 1e31);
  EXPECT_NE(of(file), "no error");
  fs::remove(file);
}

TEST_F(MerlTest, WritesAWholeFileOrNone) {
  const fs::path file = in_folder("none/t.binary");
  EXPECT_EQ(refusal(file, [&](const fs::path& f) { write_merl(table(), f); }),
            "there is no folder '" + in_folder("none").string() + "'");
  EXPECT_EQ(refusal(folder(), [&](const fs::path& f) { write_merl(table(), f); }),
            "is a folder; the name of a file is needed");
}

}  // namespace
}  // namespace scanlit
