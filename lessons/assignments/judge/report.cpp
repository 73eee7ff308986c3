#include "lessons/assignments/judge/report.h"

#include <algorithm>
#include <sstream>

#include "lessons/studio/text.h"

namespace scanlit::assignments {
namespace {

/// Text that a submission may have shaped, safe on a terminal: no character there moves the cursor
/// or changes colours.
std::string printable(std::string text) {
  for (char& c : text)
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f) c = ' ';
  return text;
}

void print_indented(std::ostream& out, const std::string& text, const char* indent,
                    int most_lines = 1000) {
  std::istringstream lines(printable(text));
  for (std::string line; std::getline(lines, line); --most_lines) {
    if (most_lines == 0) {
      out << indent << "...\n";
      return;
    }
    out << indent << line << '\n';
  }
}

}  // namespace

std::string points_text(double points) { return studio::text_of(points); }

std::string effort_text(const Effort& effort) {
  std::string text = "For a leaderboard, not for points: " + studio::grouped(effort.evaluations) +
                     " evaluations at " + studio::grouped(effort.fragments) + " fragments, ";
  if (effort.instructions > 0) text += studio::grouped(effort.instructions) + " instructions, ";
  return text + studio::fixed(1000 * effort.seconds, 2) + " ms.";
}

void print_report(std::ostream& out, const Assignment& assignment, const Verdict& verdict) {
  out << assignment.id << ", " << assignment.title << ", variant " << verdict.seed << "\n\n";
  std::size_t name_width = 5;
  for (const TestScore& test : verdict.tests) name_width = std::max(name_width, test.name.size());
  const auto row = [&](const std::string& id, const std::string& name, const std::string& result,
                       double points, double most) {
    const std::string got = points_text(points);
    out << id << std::string(8 - std::min<std::size_t>(id.size(), 6), ' ') << name
        << std::string(name_width - name.size() + 2, ' ') << result
        << std::string(8 - result.size(), ' ')
        << std::string(6 - std::min<std::size_t>(6, got.size()), ' ') << got << " of "
        << points_text(most) << '\n';
  };
  for (const TestScore& test : verdict.tests) {
    const char* const result = test.points >= test.max_points ? "passed"
                               : test.points > 0              ? "in part"
                                                              : "failed";
    row(test.id, test.name, result, test.points, test.max_points);
    if (verdict.built && !test.hidden && !test.message.empty()) {
      print_indented(out, test.message, "        ");
      if (!test.printed.empty()) {
        out << "        Your program printed:\n";
        print_indented(out, test.printed, "          ", 12);
      }
      out << '\n';
    }
  }
  if (!verdict.tests.empty() && verdict.tests.back().message.empty()) out << '\n';
  row("", "Total", "", points(verdict), max_points(verdict));
  if (verdict.effort) out << '\n' << effort_text(*verdict.effort) << '\n';
  if (!verdict.built && !verdict.tests.empty()) {
    out << '\n' << verdict.tests.front().message << '\n';
    print_indented(out, verdict.build_log, "  ");
  }
}

}  // namespace scanlit::assignments
