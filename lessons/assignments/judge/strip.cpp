#include "lessons/assignments/judge/strip.h"

#include <sstream>

#include "rasterizer/error.h"

namespace scanlit::assignments {

std::string strip(const std::string& solution, const std::string& name) {
  enum { outside, task, answer } where = outside;
  std::istringstream lines(solution);
  std::string starter;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto refuse = [&](const char* what) {
      throw Error(name + ":" + std::to_string(number), what);
    };
    ++number;
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const std::string words = line.substr(indent), blanks = line.substr(0, indent);
    const auto rest = [&] { return words.size() > 5 ? words.substr(5) : std::string(); };
    if (words.starts_with("//<<")) {
      if (where == answer) refuse("//<< in a region that was not closed");
      where = task;
      if (!rest().empty()) starter += blanks + "// " + rest() + "\n";
    } else if (words.starts_with("//==")) {
      if (where == outside) refuse("//== outside of a region");
      where = answer;
      starter += rest().empty() ? "\n" : blanks + rest() + "\n";
    } else if (words.starts_with("//>>")) {
      if (where == outside) refuse("//>> without //<<");
      where = outside;
    } else if (where == outside) {
      starter += line + "\n";
    } else {
      where = answer;
    }
  }
  if (where != outside) throw Error(name, "a region //<< is not closed by //>>");
  return starter;
}

std::string fill_in(const std::string& text, const Words& words, const std::string& name) {
  std::string filled;
  std::size_t at = 0;
  for (std::size_t open; (open = text.find("{{", at)) != text.npos;) {
    const std::size_t close = text.find("}}", open);
    if (close == text.npos) throw Error(name, "{{ without }}");
    const std::string word = text.substr(open + 2, close - open - 2);
    const auto found = words.find(word);
    if (found == words.end()) throw Error(name, "nothing is known of {{" + word + "}}");
    filled += text.substr(at, open - at) + found->second;
    at = close + 2;
  }
  return filled + text.substr(at);
}

}  // namespace scanlit::assignments
