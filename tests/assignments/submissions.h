// What is judged in these tests: starters, solutions, and the wrong solutions of each wrong.toml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lessons/assignments/judge/judge.h"

namespace scanlit::assignments::test {

/// An entry of wrong.toml.
struct WrongSolution {
  std::string name, what, text;
  std::uint64_t variant = 1;
  std::map<std::string, double> points;     // of tests that do not get all of theirs
  std::map<std::string, std::string> says;  // what must stand in a test's message
};

/// Throws Error where a text to be replaced does not stand in the solution exactly once.
std::vector<WrongSolution> wrong_solutions(const Assignment& assignment);

std::string solution_text(const Assignment& assignment);
std::string starter_text(const Assignment& assignment);

/// The verdict on this text as the file handed in, by the assignment's own rubric.
Verdict judge_text(const Assignment& assignment, const std::string& text, std::uint64_t seed = 1);

/// The same of one part alone, asked other questions.
Verdict judge_part(const Assignment& assignment, const std::string& text, const std::string& part,
                   std::uint64_t questions = 1);

}  // namespace scanlit::assignments::test
