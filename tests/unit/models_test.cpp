// The values of every model of the registry, in double, float and Batch.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tests/unit/model_conditioning.h"
#include "tests/unit/tested_models.h"

namespace scanlit {
namespace {

using namespace test;

struct ReferenceValue {
  std::string specification;
  glm::dvec3 l, v;
  glm::dvec3 value;  // pi f_r (n.l)
};

std::vector<ReferenceValue> reference_values() {
  std::ifstream file(SCANLIT_SOURCE_DIR "/tests/unit/reflection_values.csv");
  std::vector<ReferenceValue> result;
  std::string line;
  std::getline(file, line);  // names of the columns
  while (std::getline(file, line)) {
    const bool quoted = line.starts_with('"');
    const auto end = line.find(quoted ? "\"," : ",", 1);
    ReferenceValue row{line.substr(quoted, end - quoted), {}, {}, {}};
    std::istringstream numbers(line.substr(end + (quoted ? 2 : 1)));
    for (glm::dvec3* v : {&row.l, &row.v, &row.value})
      for (int c = 0; c < 3; ++c) {
        std::string number;
        std::getline(numbers, number, ',');
        (*v)[c] = std::stod(number);
      }
    result.push_back(row);
  }
  return result;
}

TEST(Models, EachHasReferenceValues) {
  std::map<std::string, int> rows;
  for (const auto& row : reference_values())
    ++rows[row.specification.substr(0, row.specification.find(':'))];
  EXPECT_GE(rows.size(), 10u);
  std::string without;
  for (const std::string& name : analytic_names())
    if (!rows.contains(name))
      without += " " + name;
    else
      EXPECT_GE(rows[name], 12) << name;
  // A table, a sum of models, or a reader's own model, made as the README says, need not have any.
  if (!without.empty()) GTEST_SKIP() << "no rows in reflection_values.csv:" << without;
}

TEST(Models, ReferenceValuesInDouble) {
  for (const auto& row : reference_values()) {
    const auto model = models::make(row.specification).model;
    const auto parts = in_double(*model, row.l, row.v);
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = row.value[int(c)];
      EXPECT_NEAR(parts[c] + parts[3 + c], expected, std::max(1e-9 * expected, 1e-12))
          << row.specification << ", n.l = " << row.l.z;
    }
  }
}

/// Where directions lose digits that float does not have: H between nearly opposite l and v,
/// cosines near 0, and the critical angle of total reflection, where F falls with infinite slope.
bool ill_conditioned(const models::NamedModel& model, const Pair& pair) {
  const double l_plus_v = glm::length(pair.l + pair.v);
  for (const auto& [key, value] : model.values)
    if (key == "eta") {
      const double eta = models::colour_of(value).r, sin2 = 1 - l_plus_v * l_plus_v / 4;
      if (std::abs(eta * eta - sin2) < 0.01) return true;
    }
  return l_plus_v < 0.1 || std::min(pair.l.z, pair.v.z) < 0.05f;
}

class Precision : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Models, Precision, testing::ValuesIn(analytic_names()), word);
INSTANTIATE_TEST_SUITE_P(Parts, Precision, testing::ValuesIn(names_of(models::Kind::part)), word);

/// Float and Batch against double at the same, float-rounded directions: within 2e-5 of the lobe's
/// maximum, times sqrt(n / 1000) for lobes sharper than n = 1000; where directions lose digits,
/// besides within what 8 roundings of them change.
TEST_P(Precision, FloatAndBatchAgreeWithDouble) {
  const Tested model = tested(GetParam());
  const std::vector<Pair> pairs = direction_pairs(20000, 1);
  Span span = span_of(pairs);
  for (const std::string& specification : model.specifications) {
    const models::NamedModel named = models::make(specification);
    const ReflectionModel& in = *named.model;
    const auto batch = span.evaluate(in);
    std::vector<std::array<double, 6>> exact;
    std::array<double, 6> peak{};
    for (const Pair& pair : pairs) {
      exact.push_back(in_double(in, pair.l, pair.v));
      for (std::size_t c = 0; c < 6; ++c) peak[c] = std::max(peak[c], exact.back()[c]);
    }
    const double share = 2e-5 * std::max(1.0, std::sqrt(sharpness(named) / 1000));
    const auto near_enough = [&](double value, std::size_t i, std::size_t c) {
      const double error = std::abs(value - exact[i][c]);
      if (error <= share * peak[c]) return true;
      return ill_conditioned(named, pairs[i]) &&
             error <= share * peak[c] + 8 * conditioning(in, pairs[i], c);
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto scalar = in_float(in, pairs[i].l, pairs[i].v);
      const bool seen = pairs[i].v.z > 0;  // a span's points are visible, a query's need not be
      for (std::size_t c = 0; c < 6; ++c) {
        ASSERT_TRUE(near_enough(scalar[c], i, c) && (!seen || near_enough(batch[i][c], i, c)))
            << specification << ", channel " << c << ": double " << exact[i][c] << ", float "
            << scalar[c] << ", Batch " << batch[i][c] << ", peak " << peak[c] << ", n.l "
            << pairs[i].l.z << " n.v " << pairs[i].v.z << " |l+v| "
            << glm::length(pairs[i].l + pairs[i].v);
      }
    }
  }
}

TEST(Models, LectureValuesAtSpecialDirections) {
  const glm::dvec3 n(0, 0, 1), l = at(0.6, 1), mirror(-l.x, -l.y, l.z);
  for (const std::string exponent : {"0", "1", "50", "1000", "100000"}) {
    const auto blinn_phong = models::make("blinn-phong:kd=.5,ks=.25,n=" + exponent).model;
    const auto phong = models::make("phong:kd=.5,ks=.25,n=" + exponent).model;
    for (const auto& model : {blinn_phong, phong}) {
      EXPECT_DOUBLE_EQ(in_double(*model, n, n)[0], 0.5);
      EXPECT_DOUBLE_EQ(in_double(*model, n, n)[3], 0.25);
      EXPECT_NEAR(in_double(*model, l, mirror)[3], 0.25, 1e-9) << "no factor N.L";
    }
    const double power = std::stod(exponent);
    const double n_h = glm::normalize(l + n).z;
    EXPECT_NEAR(in_double(*blinn_phong, l, n)[3], 0.25 * std::pow(n_h, power), 1e-12);
    EXPECT_NEAR(in_double(*phong, l, n)[3], 0.25 * std::pow(0.6, power), 1e-12);
    EXPECT_NEAR(in_double(*phong, l, l)[3], power == 0 ? 0.25 : 0, 1e-12) << "R.V < 0";
  }
}

}  // namespace
}  // namespace scanlit
