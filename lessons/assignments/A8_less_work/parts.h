// A8's question: some rows, shaded by the student's program, which asks the judge for the model.
#pragma once

#include <string>
#include <vector>

#include "lessons/assignments/A8_less_work/reference.h"
#include "lessons/assignments/judge/assignment.h"

namespace scanlit::assignments::less_work {

constexpr int rows = 12;

/// What the student's program made of them.
struct Shaded {
  double error = 0;   // the largest, of tolerances
  std::string worst;  // where that is
  int evaluations = 0;
  int fragments = 0;   // that were evaluated at all
  double seconds = 0;  // from questions to answers, without what the judge computes meanwhile
  Work work;           // that is needed
  // Row after row, of all.
  std::vector<a8::Colour> pixels, right;

  bool is_right() const { return error <= 1 + 1e-6; }  // rounding apart
};

Shaded shade_rows(Examination& e);

}  // namespace scanlit::assignments::less_work
