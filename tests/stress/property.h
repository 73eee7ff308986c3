// Properties under stress: seeded cases without end, how many were tried, and the worst one found.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace scanlit::stress {

/// How long to search, from the command line.
struct Effort {
  double seconds_each = 0;                  // for each property; 0: as many cases as it asks for
  std::optional<std::int64_t> only_case{};  // this one alone, to look into it
};
Effort& effort();

/// What a property found, as a row of the table.
struct Finding {
  std::string test, statement, range, unit;
  std::int64_t cases = 0, checks = 0;
  bool failed = false;
  double worst = 0;
  std::int64_t worst_case = 0;
  std::string worst_inputs{};
};
std::vector<Finding>& findings();

/// One property, checked for case after case:
///
///   Property property{"what holds", "for which inputs", "of what the worst is told", quick_cases};
///   while (property.next()) { ... property.random() ... property.measure(error, inputs...); }
///
/// A case is made of its number alone: --case N tries it again.
class Property {
 public:
  Property(std::string statement, std::string range, std::string unit, std::int64_t quick_cases);
  Property(const Property&) = delete;
  Property& operator=(const Property&) = delete;
  ~Property();

  /// Begins the next case; false where there were enough, or one failed.
  bool next();
  std::int64_t number() const { return case_; }
  std::mt19937_64& random() { return random_; }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  /// 10^low to 10^high, every decade as likely.
  double decades(double low, double high);
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool coin() { return whole(0, 1) == 1; }
  template <class T, class... More>
  T any_of(T first, More... more) {
    const T all[] = {first, T(more)...};
    return all[whole(0, int(sizeof...(more)))];
  }

  void checked(std::int64_t count) { finding_.checks += count; }
  /// Something of this case, larger is worse; `inputs` are written one after the other.
  template <class... Inputs>
  void measure(double value, const Inputs&... inputs) {
    ++finding_.checks;
    if (value <= finding_.worst) return;
    finding_.worst = value, finding_.worst_case = case_;
    std::ostringstream text;
    (text << ... << inputs);
    finding_.worst_inputs = text.str();
  }
  /// Of what a property is about, its cases held so much: else they say little.
  void expect_more_than(std::int64_t least, std::int64_t count) const;
  double worst() const { return finding_.worst; }

 private:
  using Clock = std::chrono::steady_clock;

  Finding finding_;
  std::int64_t quick_cases_, case_ = -1;
  Clock::time_point begin_ = Clock::now();
  std::mt19937_64 random_;
  std::optional<testing::ScopedTrace> trace_;
};

}  // namespace scanlit::stress
