// What holds for formulas of directions whatever they are in numbers: for those of which it is
// true.
#pragma once

#include <functional>

#include "lessons/assignments/judge/model_questions.h"

namespace scanlit::assignments {

/// By what a value is to be multiplied to be f_r, in 1/sr.
using BrdfScale = std::function<double(const Directions&)>;

/// f_r(L, V) = f_r(V, L), of a student's model that is neither 0 nor constant everywhere. Throws
/// Unanswered.
Finding check_reciprocity(Examination& e, const Asked& asked, const BrdfScale& f_r);

/// Of white light from all around, as much is reflected as it should be, within 2 %. Throws
/// Unanswered.
Finding check_albedo(Examination& e, const Asked& asked, const BrdfScale& f_r);

}  // namespace scanlit::assignments
