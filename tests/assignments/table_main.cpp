// Prints, as Markdown, what starters, solutions and wrong solutions score: wrong_solutions.md.
#include <algorithm>
#include <iostream>

#include "lessons/assignments/judge/report.h"
#include "tests/assignments/submissions.h"

using namespace scanlit::assignments;

namespace {

/// Where a hint stands, if there is one.
std::string last_line(const std::string& text) {
  const std::string line = text.substr(text.rfind('\n') + 1);
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// In a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != text.npos; at += 2) text.insert(at, "\\");
  return text;
}

void print_row(const std::string& name, const std::string& what, const Verdict& verdict) {
  std::cout << "| " << name << " | " << cell(what) << " |";
  std::string message;
  for (const TestScore& test : verdict.tests) {
    std::cout << ' ' << points_text(test.points) << " |";
    if (message.empty() && !test.message.empty())
      message = test.id + ": " + last_line(test.message);
  }
  std::cout << ' ' << points_text(points(verdict)) << " | " << cell(message) << " |\n";
}

}  // namespace

int main() {
  std::cout << "# Typical wrong solutions\n\nWhat they score by the rubric, variant 1 unless "
               "wrong.toml names another, and the last line that is said about them. Made by "
               "`tests/assignments/table`.\n";
  for (const Assignment& assignment : assignments()) {
    std::cout << "\n## " << assignment.id << ", " << assignment.title << "\n\n| | |";
    const Verdict solution = test::judge_text(assignment, test::solution_text(assignment));
    for (const TestScore& each : solution.tests) std::cout << ' ' << each.id << " |";
    std::cout << " all | |\n|---|---|";
    for (std::size_t i = 0; i <= solution.tests.size(); ++i) std::cout << "---|";
    std::cout << "---|\n";
    print_row("solution", "", solution);
    print_row("starter", "nothing done yet",
              test::judge_text(assignment, test::starter_text(assignment)));
    for (const test::WrongSolution& wrong : test::wrong_solutions(assignment))
      print_row(wrong.name, wrong.what, test::judge_text(assignment, wrong.text, wrong.variant));
  }
}
