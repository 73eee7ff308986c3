#include "models/specification.h"

#include "rasterizer/error.h"

namespace scanlit::models {

namespace {

/// Whether every parenthesis has its partner.
bool balanced(std::string_view text) {
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (depth < 0) return false;
  }
  return depth == 0;
}

std::vector<Argument> parse_arguments(std::string_view text) {
  std::vector<Argument> arguments;
  for (const std::string_view part : split_outside_parentheses(text, ',')) {
    const std::string_view key = split_outside_parentheses(part, '=').front();
    if (key.empty() || key.size() == part.size())  // "=1" has no key either
      arguments.push_back({"", std::string(part)});
    else
      arguments.push_back({std::string(key), std::string(part.substr(key.size() + 1))});
  }
  return arguments;
}

}  // namespace

std::vector<std::string_view> split_outside_parentheses(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += (text[i] == '(') - (text[i] == ')');
    if (depth > 0 || text[i] != separator) continue;
    parts.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::string_view without_parentheses(std::string_view text) {
  const bool enclosed = text.size() >= 2 && text.front() == '(' && text.back() == ')' &&
                        balanced(text.substr(1, text.size() - 2));
  return enclosed ? text.substr(1, text.size() - 2) : text;
}

Specification parse_specification(std::string_view text) {
  if (!balanced(text)) throw Error("'" + std::string(text) + "': a parenthesis has no partner");
  const auto colon = text.find(':');
  Specification result{std::string(text.substr(0, colon)), {}};
  if (colon != text.npos) result.arguments = parse_arguments(text.substr(colon + 1));
  return result;
}

Specification parse_call(std::string_view text) {
  if (!balanced(text)) throw Error("'" + std::string(text) + "': a parenthesis has no partner");
  const auto open = text.find('(');
  if (open == text.npos) return {std::string(text), {}};
  if (text.back() != ')')
    throw Error("'" + std::string(text) + "': there is text after the last parenthesis");
  const std::string_view inside = text.substr(open + 1, text.size() - open - 2);
  Specification result{std::string(text.substr(0, open)), {}};
  if (!inside.empty()) result.arguments = parse_arguments(inside);
  return result;
}

}  // namespace scanlit::models
