#include "lessons/studio/explain/rows.h"

#include <cmath>
#include <cstdio>

#include "lessons/studio/text.h"

namespace scanlit::studio {

std::string short_text(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

namespace {

/// With the points below one another, unless it is too small or too large for that.
std::string cell_text(double value, int decimals) {
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-5 && size < 1e5);
  return plain ? fixed(value, decimals) : short_text(value, 4);
}

}  // namespace

std::string plural(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

void Rows::title(const std::string& text, const std::vector<std::string>& columns) const {
  out_ << '\n';
  line(text, columns, "");
}

void Rows::text(const std::string& label, const std::string& words) const {
  line("  " + label, {}, words);
}

void Rows::numbers(const std::string& label, const std::vector<double>& values,
                   const std::string& remark, int decimals) const {
  std::vector<std::string> cells;
  for (const double value : values) cells.push_back(cell_text(value, decimals));
  line("  " + label, cells, remark);
}

void Rows::line(const std::string& label, const std::vector<std::string>& cells,
                const std::string& remark) const {
  constexpr std::size_t label_width = 25, cell_width = 12;
  const auto blanks = [](std::size_t width, const std::string& text) {
    return std::string(text.size() < width ? width - text.size() : 1, ' ');
  };
  std::string all = label + blanks(label_width, label);
  for (const std::string& cell : cells) all += blanks(cell_width, cell) + cell;
  if (!remark.empty()) all += (cells.empty() ? "" : "   ") + remark;
  all.erase(all.find_last_not_of(' ') + 1);
  out_ << all << '\n';
}

}  // namespace scanlit::studio
