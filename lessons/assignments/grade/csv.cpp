#include "lessons/assignments/grade/csv.h"

#include <cmath>

#include "lessons/studio/text.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {

std::vector<CsvRow> read_csv(const std::string& where, std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (text.find('\0') != text.npos) throw Error(where, "is not text");
  std::vector<CsvRow> rows;
  CsvRow row;
  std::string cell;
  bool quoted = false, was_quoted = false;
  const auto end_cell = [&] {
    row.push_back(std::move(cell));
    cell.clear();
    was_quoted = false;
  };
  const auto end_row = [&] {
    if (row.empty() && cell.empty() && !was_quoted) return;
    end_cell();
    rows.push_back(std::move(row));
    row.clear();
  };
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted) {
      const bool doubled = c == '"' && at + 1 < text.size() && text[at + 1] == '"';
      if (c != '"' || doubled) cell += c;
      at += doubled;
      quoted = c != '"' || doubled;
    } else if (c == '"' && cell.empty()) {
      quoted = was_quoted = true;
    } else if (c == ',') {
      end_cell();
    } else if (c == '\n') {
      end_row();
    } else if (c != '\r') {
      cell += c;
    }
  }
  if (quoted) throw Error(where, "a quote is opened and never closed");
  end_row();
  return rows;
}

std::string csv_text(std::string_view text) {
  std::string cell;
  constexpr std::string_view formula = "=+-@\t\r";
  if (!text.empty() && formula.find(text.front()) != formula.npos) cell = "'";
  for (const char c : text) cell += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  if (cell.find_first_of(",\"'") == cell.npos && cell.find(' ') == cell.npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_number(double number) {
  return std::isfinite(number) ? studio::text_of(number) : std::string("0");
}

std::string csv_line(const CsvRow& cells) {
  std::string line;
  for (const std::string& cell : cells)
    line += (line.empty() && &cell == &cells[0] ? "" : ",") + cell;
  return line + "\r\n";
}

}  // namespace scanlit::assignments
