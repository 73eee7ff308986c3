// UTIA tables: the look-up in four angles, the poles, beyond 75 degrees, files.
#include <limits>
#include <numbers>

#include "models/lambert.h"
#include "tests/unit/measured_tables.h"

namespace scanlit {
namespace {

using namespace test;
using namespace models;

constexpr double degree = std::numbers::pi / 180;

Vec3<double> at_degrees(double theta, double phi) {
  return {std::sin(theta * degree) * std::cos(phi * degree),
          std::sin(theta * degree) * std::sin(phi * degree), std::cos(theta * degree)};
}

using UtiaModel = FormulaModel<Utia>;

class UtiaTest : public MeasuredTest {
 protected:
  template <class Formula>
  static UtiaTable table_of() {
    const fs::path file = in_folder("t.bin");
    tabulate_utia(model_of<Formula>(), file);
    const UtiaTable table = read_utia(file);
    fs::remove(file);
    return table;
  }
};

TEST_F(UtiaTest, IsExactAtTheTablesAngles) {
  const UtiaModel utia{Utia(table_of<Brushed>())};
  EXPECT_TRUE(utia.needs().frame);
  const auto source = model_of<Brushed>();
  for (int l = 0; l < int(UtiaTable::directions); l += 5)
    for (int v = 0; v < int(UtiaTable::directions); v += 7) {
      const auto to_light = UtiaTable::direction(l / 48, l % 48);
      const auto to_viewer = UtiaTable::direction(v / 48, v % 48);
      EXPECT_LT(distance(whole(utia, to_light, to_viewer), whole(source, to_light, to_viewer)),
                1e-12)
          << l << ' ' << v;
    }
}

TEST_F(UtiaTest, OneEntryIsWhereTheFormatSays) {
  // theta_l 30, phi_l 75, theta_v 60, phi_v 352.5 degrees.
  UtiaTable table{std::vector<Rgb<double>>(UtiaTable::size)};
  table.entries[288 * (48 * 2 + 10) + 48 * 4 + 47] = {1, 2, 3};
  const UtiaModel utia{Utia(table)};
  const double scale = std::numbers::pi * std::cos(30 * degree);
  const auto value = [&](double tl, double pl, double tv, double pv) {
    return whole(utia, at_degrees(tl, pl), at_degrees(tv, pv)).r / scale;
  };
  EXPECT_NEAR(value(30, 75, 60, 352.5), 1, 1e-12);
  EXPECT_NEAR(whole(utia, at_degrees(30, 75), at_degrees(60, -7.5)).b / scale, 3, 1e-12);
  EXPECT_NEAR(value(30, 75, 60, 356.25), 0.5, 1e-12) << "half-way to phi 0";
  EXPECT_NEAR(value(30, 75, 67.5, 352.5), 0.5, 1e-12);
  EXPECT_NEAR(value(30, 80.625, 60, 352.5), 0.25, 1e-12);
  EXPECT_NEAR(value(60, 352.5, 30, 75), 0, 1e-12) << "not reciprocal";
  EXPECT_NEAR(value(30, 255, 60, 172.5), 0, 1e-12) << "turned by half a circle";
}

TEST_F(UtiaTest, AgreesWithItsSourceToTheTablesResolution) {
  const UtiaModel utia{Utia(table_of<Brushed>())};
  const auto source = model_of<Brushed>();
  std::mt19937 random(1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 a = direction(random), b = direction(random);
    const Vec3<double> l{a.x, a.y, std::abs(a.z)}, v{b.x, b.y, std::abs(b.z)};
    if (std::min(l.z, v.z) < std::cos(75 * degree)) continue;
    worst = std::max(worst, distance(whole(utia, l, v), whole(source, l, v)));
  }
  EXPECT_LT(worst, 0.01);  // of values up to 1.1; an eighth of a step squared times curvature
}

TEST_F(UtiaTest, ATableOfAConstantIsConstantAlsoBeyondItsEnd) {
  const UtiaModel utia{Utia(table_of<Lambert<>>())};
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 a = direction(random), b = direction(random);
    const Vec3<double> l{a.x, a.y, std::abs(a.z)}, v{b.x, b.y, std::abs(b.z)};
    EXPECT_LT(distance(whole(utia, l, v), Rgb<double>(0.8 * l.z)), 1e-12);
  }
}

TEST_F(UtiaTest, Beyond75DegreesTheReflectanceIsHeldAndTheLightStillFalls) {
  const UtiaModel utia{Utia(table_of<Brushed>())};
  const auto v = at_degrees(40, 110);
  const auto f_r = [&](double theta) {
    const auto l = at_degrees(theta, 20);
    return whole(utia, l, v) * (1 / l.z);
  };
  for (const double theta : {76.0, 83.0, 89.0, 89.99})
    EXPECT_LT(distance(f_r(theta), f_r(75)), 1e-9) << theta;
  EXPECT_GT(distance(f_r(74), f_r(75)), 1e-4);
}

TEST_F(UtiaTest, HasOneValueAtThePoleWhateverTheTableHoldsThere) {
  UtiaTable table = table_of<Brushed>();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(0.9, 1.1);
  for (auto& entry : table.entries) entry = entry * noise(random);
  const UtiaModel utia{Utia(table)};
  const auto other = at_degrees(33, 200);
  const Vec3<double> n{0, 0, 1};
  for (double phi = 0; phi < 360; phi += 11) {
    const auto near = at_degrees(1e-6, phi);
    EXPECT_LT(distance(whole(utia, near, other), whole(utia, n, other)), 1e-6) << phi;
    EXPECT_LT(distance(whole(utia, other, near), whole(utia, other, n)), 1e-6) << phi;
    EXPECT_LT(distance(whole(utia, near, near), whole(utia, n, n)), 1e-6) << phi;
  }
}

TEST_F(UtiaTest, TurnsWithTheTangent) {
  const UtiaModel utia{Utia(table_of<Brushed>())};
  std::mt19937 random(4);
  Span span = random_span(1001, random);
  const auto batch = span.evaluate(utia);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const glm::dvec3 n = span.get(i, Span::normal), t = span.get(i, Span::tangent);
    const auto local = [&](int which) {
      const glm::dvec3 d = span.get(i, which);
      return glm::dvec3(glm::dot(d, t), glm::dot(d, glm::cross(n, t)), glm::dot(d, n));
    };
    const auto expected = in_double(utia, local(Span::to_light), local(Span::to_viewer));
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(batch[i][c], expected[c], 1e-5) << i;
  }
  const auto l = at_degrees(40, 10), v = at_degrees(30, 70), l90 = at_degrees(40, 100),
             v90 = at_degrees(30, 160);
  EXPECT_GT(distance(whole(utia, l, v), whole(utia, l90, v90)), 0.01) << "anisotropic";
}

TEST_F(UtiaTest, IsSoundEverywhereInAllPrecisions) {
  expect_sound(UtiaModel{Utia(table_of<Brushed>())}, [](const Pair&) { return true; });
  // Measurements have negative entries.
  UtiaTable table{std::vector<Rgb<double>>(UtiaTable::size, Rgb<double>(-0.01, 0.2, -1e30))};
  const UtiaModel utia{Utia(table)};
  expect_sound(utia, [](const Pair&) { return true; });
  EXPECT_EQ(in_double(utia, {0, 0, 1}, {0, 0, 1})[3], 0);
}

TEST_F(UtiaTest, EntriesAreDecodedAndScaledAsTold) {
  UtiaTable table{std::vector<Rgb<double>>(UtiaTable::size, Rgb<double>(0.5, 0.02, 1))};
  const auto f_r = [&](const UtiaModel& utia) {
    return whole(utia, {0, 0, 1}, {0, 0, 1}) * (1 / std::numbers::pi);
  };
  EXPECT_LT(distance(f_r(UtiaModel{Utia(table)}), {0.5, 0.02, 1}), 1e-12);
  EXPECT_LT(distance(f_r(UtiaModel{Utia(table, UtiaEncoding::srgb, 2)}),
                     {2 * 0.21404114048, 0.04 / 12.92, 2}),
            1e-9);
}

TEST_F(UtiaTest, TheLargestEntryStaysInFloatHoweverItIsEncoded) {
  const UtiaTable table{std::vector<Rgb<double>>(UtiaTable::size, Rgb<double>(1e30))};
  const UtiaModel utia{Utia(table, UtiaEncoding::srgb, 1000)};
  const Vec3<float> up{0, 0, 1};
  EXPECT_TRUE(std::isfinite(utia.evaluate(up, up, SurfacePoint<float>{}).glossy.r));
}

TEST_F(UtiaTest, IsMadeFromWords) {
  tabulate_utia(model_of<Brushed>(), in_folder("t.bin"));
  const UtiaTable table = read_utia(in_folder("t.bin"));
  const auto l = at_degrees(40, 10), v = at_degrees(30, 70);
  const auto value = [&](const std::string& words) {
    return whole(*make("utia:file=t.bin" + words, folder()).model, l, v);
  };
  EXPECT_EQ(value(""), whole(UtiaModel{Utia(table)}, l, v));
  EXPECT_EQ(value(",encoding=srgb,scale=3"),
            whole(UtiaModel{Utia(table, UtiaEncoding::srgb, 3)}, l, v));
  EXPECT_EQ(refusal("model 'utia'", [](const fs::path&) { make("utia"); }),
            "'file' must be given: a table of 3 * 288 * 288 numbers: x.bin");
}

TEST_F(UtiaTest, ReadThenWrittenTheBytesAreTheSame) {
  const fs::path first = in_folder("first.bin"), second = in_folder("second.bin");
  tabulate_utia(model_of<Brushed>(), first);
  patch(first, 8 * 4711, -3.25);
  patch(first, 8 * 4712, -0.0);
  write_utia(read_utia(first), second);
  EXPECT_TRUE(bytes_of(first) == bytes_of(second));
}

TEST_F(UtiaTest, RefusesFilesThatAreNoTable) {
  const auto of = [](const fs::path& file) { return refusal(file, read_utia); };
  EXPECT_EQ(of(in_folder("none")), "there is no such file");
  EXPECT_EQ(of(folder()), "is a folder, not a table");
  EXPECT_EQ(of("/dev/zero"), "is not a regular file");
  const fs::path file = written("u.bin", "");
  for (const auto size : {0u, 8u, 1990655u, 1990657u}) {
    fs::resize_file(file, size);
    EXPECT_EQ(of(file), "the file is " + std::to_string(size) +
                            " bytes long; a UTIA table is 3 * 288 * 288 * 8 = 1990656");
  }
  fs::resize_file(file, 1990656);
  EXPECT_EQ(of(file), "no error");
  patch(file, 8 * (2 * UtiaTable::size + 7), std::numeric_limits<double>::infinity());
  EXPECT_EQ(of(file),
            "blue entry 7 (counted from 0; at byte 1327160) is inf; entries are finite and within "
            "+-1e+30");
}

}  // namespace
}  // namespace scanlit
