// What the tests of measured tables share: a folder of their own, models whose tables have a known
// right answer, one MERL file for all tests of a process (it is 35 MB), a refusal's words.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>

#include "models/measured/merl.h"
#include "models/measured/tabulate.h"
#include "models/measured/utia.h"
#include "rasterizer/error.h"
#include "rasterizer/formula_model.h"
#include "tests/unit/model_queries.h"

namespace scanlit::test {

namespace fs = std::filesystem;

/// Isotropic and reciprocal, broad, coloured, and its own mirror image's opposite: what a wrong
/// sign or fold of phi_d would show. f_r pi = 0.3 + 0.5 (N.H)^20 + 0.5 N.L N.V + 0.2 [N L V] (N.L -
/// N.V).
struct Chiral {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T triple = f.l.x * f.v.y - f.l.y * f.v.x;
    const T lobe = T(0.5) * pow(c.n_h, T(20));
    const T rest = T(0.5) * c.n_l * c.n_v + T(0.2) * triple * (c.n_l - c.n_v);
    return {.diffuse = Rgb<double>(1, 0.7, 0.3) * (T(0.3) * c.n_l),
            .glossy = Rgb<double>(0.9, 1, 0.5) * ((lobe + rest) * c.n_l)};
  }
};

/// Anisotropic, and different when light and viewer change places.
struct Brushed {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T along = f.l.x * f.v.x, across = f.l.y * f.v.y;
    const T f_r = T(0.5) + T(0.3) * along * along + T(0.1) * across + T(0.2) * f.l.y * f.v.z;
    return {.diffuse = Rgb<double>(1, 0.6, 0.2) * (f_r * c.n_l), .glossy = Rgb<T>(T(0))};
  }
};

template <class Formula>
FormulaModel<Formula> model_of() {
  return FormulaModel<Formula>(Formula{});
}

inline Rgb<double> whole(const ReflectionModel& model, const Vec3<double>& l,
                         const Vec3<double>& v) {
  const Reflection<double> parts = model.evaluate(l, v);
  return parts.diffuse + parts.glossy;
}

/// The largest difference of a channel.
inline double distance(const Rgb<double>& a, const Rgb<double>& b) {
  const Rgb<double> d = a - b;
  return std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)});
}

class MeasuredTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { fs::create_directories(folder()); }
  static void TearDownTestSuite() { fs::remove_all(folder()); }

  static fs::path folder() {
    return fs::path(testing::TempDir()) / ("scanlit-measured-" + std::to_string(getpid()));
  }
  static fs::path in_folder(const std::string& name) { return folder() / name; }

  /// The first words of the refusal are the file's name; what is returned follows.
  template <class Action>
  static std::string refusal(const fs::path& file, const Action& action) {
    try {
      action(file);
    } catch (const Error& error) {
      const std::string what = error.what(), start = file.string() + ": ";
      EXPECT_TRUE(what.starts_with(start)) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what.substr(std::min(what.size(), start.size()));
    }
    return "no error";
  }

  static fs::path written(const std::string& name, const std::string& bytes) {
    std::ofstream(in_folder(name), std::ios::binary) << bytes;
    return in_folder(name);
  }
  static std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

/// Changes a number in a file.
template <class Number>
void patch(const fs::path& file, std::size_t byte, Number number) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekp(std::streamoff(byte));
  stream.write(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Finite, not negative, and Batch as float, at random and degenerate directions. `comparable` says
/// where a table has no border.
inline void expect_sound(const ReflectionModel& model,
                         const std::function<bool(const Pair&)>& comparable) {
  const std::vector<Pair> pairs = direction_pairs(4000, 7);
  const auto batch = span_of(pairs).evaluate(model);
  int compared = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto exact = in_double(model, pairs[i].l, pairs[i].v);
    const auto scalar = in_float(model, pairs[i].l, pairs[i].v);
    for (std::size_t c = 0; c < 6; ++c) {
      ASSERT_TRUE(std::isfinite(exact[c]) && exact[c] >= 0) << i;
      ASSERT_TRUE(std::isfinite(scalar[c]) && scalar[c] >= 0) << i;
      ASSERT_TRUE(std::isfinite(batch[i][c]) && batch[i][c] >= 0) << i;
      const bool lit = pairs[i].l.z > 0, seen = pairs[i].v.z > 0;
      ASSERT_TRUE((lit && seen) || (exact[c] == 0 && scalar[c] == 0)) << i;
      ASSERT_TRUE(lit || batch[i][c] == 0) << i;
      if (!seen || !comparable(pairs[i])) continue;
      ASSERT_NEAR(batch[i][c], scalar[c], 1e-5) << i;
      ASSERT_NEAR(scalar[c], exact[c], 2e-5) << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 3000);
}

}  // namespace scanlit::test
