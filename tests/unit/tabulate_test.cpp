// From models to tables, and what a format cannot hold.
#include <numbers>

#include "models/blinn_phong.h"
#include "models/lambert.h"
#include "models/phong.h"
#include "tests/unit/measured_tables.h"

namespace scanlit {
namespace {

using namespace test;
using namespace models;

class TabulateTest : public MeasuredTest {
 protected:
  /// Nothing is written where the model is refused.
  static std::string merl_refusal(const ReflectionModel& model) {
    const fs::path file = in_folder("refused.binary");
    const auto words = refusal(file, [&](const fs::path& f) { tabulate_merl(model, f); });
    EXPECT_FALSE(fs::exists(file));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder()), fs::directory_iterator()), 0);
    return words.substr(0, words.find(';'));
  }
};

constexpr auto anisotropic =
    "a MERL table holds isotropic models, and this one changes when the surface is turned about "
    "its normal";
constexpr auto not_reciprocal =
    "a MERL table holds reciprocal models, and f_r of this one changes when light and viewer "
    "change places";

/// Highlights a hundredth of a degree wide, anisotropic or not reciprocal there and nowhere else.
struct SharpAnisotropic {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T lobe = pow(c.n_h, T(1e8)) * (T(1) + f.h.x * f.h.x / (T(1e-12) + c.n_h.sin2()));
    return {.diffuse = Rgb<T>(T(0)), .glossy = Rgb<T>(lobe * c.n_l)};
  }
};
struct SharpOneWay {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = Rgb<T>(T(0)), .glossy = Rgb<T>(pow(c.n_h, T(1e8)))};
  }
};
struct Infinite {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = Rgb<T>(T(1) / (c.n_h.versine - c.n_h.versine)), .glossy = Rgb<T>(T(0))};
  }
};

TEST_F(TabulateTest, LambertAsAMerlTableIsLambert) {
  const fs::path file = in_folder("lambert.binary");
  tabulate_merl(model_of<Lambert<>>(), file);
  EXPECT_EQ(fs::file_size(file), 34992012u);
  const MerlTable table = read_merl(file);
  fs::remove(file);
  for (int h = 0; h < 90; ++h)
    for (int d = 0; d < 90; ++d)
      for (int p = 0; p < 180; ++p) {
        const auto [l, v] = directions(MerlTable::centre(h, d, p));
        const bool measured = std::min(l.z, v.z) >= min_n_v;
        const double entry = table.entries[MerlTable::index(h, d, p)].r;
        ASSERT_NEAR(entry, measured ? 0.8 / std::numbers::pi * 1500 : -1, 1e-9);
      }
  const Merl merl(table);
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 a = direction(random), b = direction(random);
    const Vec3<double> l{a.x, a.y, std::abs(a.z)}, v{b.x, b.y, std::abs(b.z)};
    if (std::min(l.z, v.z) < 0.03) continue;
    EXPECT_LT(distance(whole(merl, l, v), Rgb<double>(0.8 * l.z)), 1e-12);
  }
}

TEST_F(TabulateTest, MerlRefusesWhatTheFormatCannotHold) {
  EXPECT_EQ(merl_refusal(model_of<Brushed>()), anisotropic);
  EXPECT_EQ(merl_refusal(model_of<SharpAnisotropic>()), anisotropic);
  EXPECT_EQ(merl_refusal(model_of<BlinnPhong<>>()), not_reciprocal);
  EXPECT_EQ(merl_refusal(model_of<SharpOneWay>()), not_reciprocal);
  EXPECT_NE(merl_refusal(model_of<Infinite>()), "no error");
}

TEST_F(TabulateTest, UtiaTakesAnythingFinite) {
  const fs::path file = in_folder("t.bin");
  tabulate_utia(model_of<Phong<>>(), file);
  const FormulaModel<Utia> utia{Utia(read_utia(file))};
  const auto source = model_of<Phong<>>();
  const auto l = UtiaTable::direction(4, 0), v = UtiaTable::direction(4, 24);
  EXPECT_LT(distance(whole(utia, l, v), whole(source, l, v)), 1e-12);
  fs::remove(file);
  const auto words =
      refusal(file, [&](const fs::path& f) { tabulate_utia(model_of<Infinite>(), f); });
  EXPECT_EQ(words,
            "the model's f_r at l = (0, 0, 1), v = (0, 0, 1) is inf, which a table cannot hold");
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(TabulateTest, SaysWhereItCannotWrite) {
  EXPECT_EQ(refusal(in_folder("none/t.bin"),
                    [](const fs::path& f) { tabulate_utia(model_of<Brushed>(), f); }),
            "there is no folder '" + in_folder("none").string() + "'");
}

}  // namespace
}  // namespace scanlit
