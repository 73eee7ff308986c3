#include "lessons/studio/table.h"

#include <algorithm>
#include <sstream>

namespace scanlit::studio {
namespace {

/// `column` is where the first word would go; lines that follow start with `indent`.
void print_words(std::ostream& out, const std::string& text, std::size_t column,
                 const std::string& indent) {
  std::istringstream words(text);
  bool first = true;
  for (std::string word; words >> word; first = false) {
    if (!first && column + 1 + word.size() > terminal_columns) {
      out << '\n' << indent;
      column = indent.size();
    } else if (!first) {
      out << ' ';
      ++column;
    }
    // A specification may be wider than a line; a comma is where it is read apart.
    const std::size_t room = terminal_columns - indent.size();
    while (word.size() > room) {
      const std::size_t cut = word.rfind(',', room - 1);
      if (cut == word.npos) break;
      out << word.substr(0, cut + 1) << '\n' << indent;
      word.erase(0, cut + 1);
      column = indent.size();
    }
    out << word;
    column += word.size();
  }
  out << '\n';
}

}  // namespace

void print_wrapped(std::ostream& out, const std::string& text, const std::string& indent) {
  out << indent;
  print_words(out, text, indent.size(), indent);
}

void print_columns(std::ostream& out, const std::vector<std::vector<std::string>>& rows,
                   const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const auto& row : rows) {
    std::string line = indent;
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    out << line;
    print_words(out, row.back(), line.size(), std::string(line.size(), ' '));
  }
}

}  // namespace scanlit::studio
