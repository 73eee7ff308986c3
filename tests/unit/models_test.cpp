// The values of every model of the registry, in double, float and Batch.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;

using models::ModelInfo;

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
  EXPECT_GE(rows.size(), 3u);
  std::string without;
  for (const ModelInfo& info : models::list())
    if (!rows.contains(info.name))
      without += " " + info.name;
    else
      EXPECT_GE(rows[info.name], 12) << info.name;
  // A reader's own model, made as the README says, need not have any.
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

TEST(Models, FloatAndBatchAgreeWithDouble) {
  std::vector<Pair> pairs = direction_pairs(20000, 1);
  for (const auto& row : reference_values()) pairs.push_back({row.l, row.v});
  Span span = span_of(pairs);
  for (const ModelInfo& info : models::list())
    for (const std::string& specification : specifications(info)) {
      const models::NamedModel named = models::make(specification);
      const auto batch = span.evaluate(*named.model);
      std::vector<std::array<double, 6>> exact;
      std::array<double, 6> peak{};
      for (const Pair& pair : pairs) {
        exact.push_back(in_double(*named.model, pair.l, pair.v));
        for (std::size_t c = 0; c < 6; ++c) peak[c] = std::max(peak[c], exact.back()[c]);
      }
      const double share = 2e-5 * std::max(1.0, std::sqrt(exponent(named) / 1000));
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto scalar = in_float(*named.model, pairs[i].l, pairs[i].v);
        const bool seen = pairs[i].v.z > 0;  // a span's points are visible, a query's need not be
        for (std::size_t c = 0; c < 6; ++c) {
          ASSERT_NEAR(scalar[c], exact[i][c], share * peak[c])
              << specification << " float, n.l " << pairs[i].l.z << " n.v " << pairs[i].v.z;
          if (!seen) continue;
          ASSERT_NEAR(batch[i][c], exact[i][c], share * peak[c])
              << specification << " Batch, n.l " << pairs[i].l.z << " n.v " << pairs[i].v.z;
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
