// FROM:TO, what a parameter is in the first frame and in the last.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/studio/scene_file.h"

namespace scanlit::studio {

/// Numbers that go from one list to another of the same length.
struct Sweep {
  std::vector<double> from, to;

  std::vector<double> at(double share) const;  // exactly `from` at 0 and `to` at 1
};

/// ".05:.6", or lists: "1,0,0:0,1,0", "1/0/0:0/1/0". Nothing where the text is no such thing.
/// Throws Error with `where`: as many numbers on one side as on the other are needed.
std::optional<Sweep> parse_sweep(const std::string& where, std::string_view text);

/// An option's text with a number, or a list, in the place of each FROM:TO that is all of it or a
/// value of a model in it: "cook-torrance:m=.05:.6,F=copper".
std::string text_at(const std::string& where, const std::string& text, double share);

/// --sweep PATH=FROM:TO
struct PathSweep {
  std::string path;
  Sweep sweep;
};
PathSweep parse_path_sweep(const std::string& text);

}  // namespace scanlit::studio
