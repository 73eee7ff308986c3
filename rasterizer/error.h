// Every refusal of bad input is an Error: one line that says where, what is wrong, what would be
// right. The library throws it at load and construction; only a program's main() turns it into
// "error: ..." on stderr and exit code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace scanlit {

class Error : public std::runtime_error {
 public:
  /// what: "unknown model 'blin-phong'; did you mean 'blinn-phong'?"
  explicit Error(const std::string& what) : std::runtime_error(what) {}
  /// where: "scene.toml:12:5", "bunny.obj:17", "--samples"; the message is "where: what".
  Error(const std::string& where, const std::string& what) : Error(where + ": " + what) {}
};

/// "; did you mean 'blinn-phong'?" for the candidate nearest to `word` in edit distance, where one
/// is near enough (a third of its length), else "; there are: a, b, c".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scanlit
