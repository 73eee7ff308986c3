// An autograder for Gradescope: a zip with setup.sh and run_autograder at its root.
#pragma once

#include <filesystem>

#include "lessons/assignments/judge/assignment.h"

namespace scanlit::assignments {

struct Pack {
  std::filesystem::path rubric;  // empty: the assignment's own
  std::filesystem::path hidden;  // folder of hidden tests; empty: none
  std::filesystem::path output;  // the zip
};

/// Packs the engine's and the judge's sources without any solution: setup.sh builds them where the
/// grading is to be, for any x86-64-v2 processor. Throws Error: the sources are not there (an
/// installed program), there is no cmake, the rubric is of another assignment, a file that cannot
/// be read or written.
void pack(const Assignment& assignment, const Pack& what);

}  // namespace scanlit::assignments
