// Who is asked: the student's program, which answers in numbers, and never sees what is made of
// them.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scanlit::assignments {

/// What crosses the pipe: whole numbers and finite real ones.
struct Numbers {
  std::vector<std::int64_t> integers;
  std::vector<double> reals;
};

/// A question that was not answered as it should be; the message is the judge's own words. The test
/// it was asked in scores 0.
class Unanswered : public std::runtime_error {
 public:
  explicit Unanswered(const std::string& what, bool in_time = true)
      : std::runtime_error(what), answered_in_time(in_time) {}
  bool answered_in_time;
};

/// How many numbers an answer may hold at most, and at least where both must be met.
struct AnswerSize {
  std::size_t least_integers = 0, most_integers = 0;
  std::size_t least_reals = 0, most_reals = 0;

  static AnswerSize integers(std::size_t count) { return {count, count, 0, 0}; }
  static AnswerSize reals(std::size_t count) { return {0, 0, count, count}; }
};

/// Answers what the student's code asks while it answers: its kind and numbers to numbers.
using Counsel = std::function<Numbers(int kind, const Numbers& question)>;

class Respondent {
 public:
  virtual ~Respondent() = default;

  /// Throws Unanswered: no answer in time, the program ended, numbers that are not finite, more or
  /// fewer of them than `size` allows, a question of its own where there is no counsel.
  virtual Numbers ask(int kind, const Numbers& question, const AnswerSize& size,
                      const Counsel& counsel = {}) = 0;

  /// Whoever is asked next has been asked nothing before.
  virtual void start_anew() = 0;
};

}  // namespace scanlit::assignments
