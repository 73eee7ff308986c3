#include "tests/stress/property.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace scanlit::stress {

// The sanitizers make everything some 20 times slower.
#ifdef __SANITIZE_ADDRESS__
constexpr std::int64_t slowness = 20;
#else
constexpr std::int64_t slowness = 1;
#endif

Effort& effort() {
  static Effort effort;
  return effort;
}

std::vector<Finding>& findings() {
  static std::vector<Finding> findings;
  return findings;
}

Property::Property(std::string statement, std::string range, std::string unit,
                   std::int64_t quick_cases)
    : quick_cases_(std::max<std::int64_t>(1, quick_cases / slowness)) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  finding_.test = info ? std::string(info->test_suite_name()) + "." + info->name() : statement;
  finding_.statement = std::move(statement);
  finding_.range = std::move(range);
  finding_.unit = std::move(unit);
}

Property::~Property() {
  trace_.reset();
  if (!testing::UnitTest::GetInstance()->current_test_info()) return;
  finding_.failed = testing::Test::HasFailure();
  const Finding& f = finding_;
  std::cout << f.test << ": " << f.statement << "\n  " << f.cases << " cases, " << double(f.checks)
            << " checks; " << f.range << "\n  worst: ";
  if (f.worst > 0)
    std::cout << f.worst << ' ' << f.unit << ", case " << f.worst_case << ": " << f.worst_inputs;
  else
    std::cout << "0 " << f.unit;
  std::cout << std::endl;
  findings().push_back(f);
}

bool Property::next() {
  const auto only = effort().only_case;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  const bool enough = only ? finding_.cases == 1
                      : effort().seconds_each == 0
                          ? finding_.cases == quick_cases_
                          : finding_.cases >= quick_cases_ && seconds > effort().seconds_each;
  trace_.reset();
  if (enough || testing::Test::HasFailure()) return false;
  case_ = only ? *only : case_ + 1;
  ++finding_.cases;
  std::seed_seq seed(finding_.test.begin(), finding_.test.end());
  std::uint32_t words[2];
  seed.generate(words, words + 2);
  std::seed_seq both{words[0], words[1], std::uint32_t(case_), std::uint32_t(case_ >> 32)};
  random_.seed(both);
  trace_.emplace(__FILE__, __LINE__, "--case " + std::to_string(case_));
  return true;
}

void Property::expect_more_than(std::int64_t least, std::int64_t count) const {
  if (effort().only_case) return;
  EXPECT_GT(count, least / slowness);
}

double Property::decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }

}  // namespace scanlit::stress
