// Comma-separated values (RFC 4180), read and written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scanlit::assignments {

using CsvRow = std::vector<std::string>;

/// `where` names the file in messages. A byte order mark and empty lines are skipped. Throws Error:
/// a quote that nobody closes, a NUL.
std::vector<CsvRow> read_csv(const std::string& where, std::string_view text);

/// A cell that a spreadsheet shows as it is and never computes: what begins like a formula gets an
/// apostrophe, control characters become blanks.
std::string csv_text(std::string_view text);
/// A cell of a number.
std::string csv_number(double number);

/// Cells made by csv_text() and csv_number(), and the line's end.
std::string csv_line(const CsvRow& cells);

}  // namespace scanlit::assignments
