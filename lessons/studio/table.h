// Text in aligned columns.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace scanlit::studio {

constexpr std::size_t terminal_columns = 100;

/// Columns two blanks apart, each as wide as its longest cell; the last one is wrapped to
/// terminal_columns.
void print_columns(std::ostream& out, const std::vector<std::vector<std::string>>& rows,
                   const std::string& indent);

/// Words of `text` in lines that start with `indent` and end before terminal_columns.
void print_wrapped(std::ostream& out, const std::string& text, const std::string& indent);

}  // namespace scanlit::studio
