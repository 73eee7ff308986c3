// Starter from solution. In a solution
//
//   //<< TODO(A1.2) Whether the triangle owns the points on this edge.
//   return edge.a > 0;
//   //== return true;
//   //>>
//
// what stands between the first and the last line is the answer, and lines that begin with //==
// take its place, so that the starter has
//
//   // TODO(A1.2) Whether the triangle owns the points on this edge.
//   return true;
//
// Further lines of the task, before the answer, begin with //<< too. A region outside of which only
// the answer would need it (a helper, an include) has no TODO: "//<<" alone.
#pragma once

#include <string>

#include "lessons/assignments/judge/assignment.h"

namespace scanlit::assignments {

/// `name` is the file's, for Error: a region that is not closed, or opened twice.
std::string strip(const std::string& solution, const std::string& name);

/// Every {{word}} replaced by what it stands for. Throws Error, naming the file, where a word
/// stands for nothing.
std::string fill_in(const std::string& text, const Words& words, const std::string& name);

}  // namespace scanlit::assignments
