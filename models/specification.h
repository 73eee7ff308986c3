// How a model is written down: "name:key=value,...", the same on the command line, in scene files
// and in tests.
//
//   blinn-phong:kd=.6/.3/.1,n=50
//   lambert:kd=image(cow.png)                     a value may be an input with arguments,
//   clear-coat:base=(lambert:kd=.5),eta=1.5       or another model in parentheses
//
// Commas and = inside parentheses belong to the value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scanlit::models {

struct Argument {
  std::string key;    // empty where there is none
  std::string value;  // as written, with its parentheses
};

struct Specification {
  std::string name;
  std::vector<Argument> arguments;
};

/// "name:arguments". Throws Error where parentheses do not match, at any depth.
Specification parse_specification(std::string_view text);

/// "name(arguments)" or "name": how inputs are written.
Specification parse_call(std::string_view text);

/// Texts between separators that stand outside all parentheses; at least one.
std::vector<std::string_view> split_outside_parentheses(std::string_view text, char separator);

/// "(text)" without its parentheses; other text as it is.
std::string_view without_parentheses(std::string_view text);

}  // namespace scanlit::models
