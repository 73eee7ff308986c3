// What a right program costs, apart from points.
#pragma once

#include <optional>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/rubric.h"
#include "lessons/assignments/sandbox/sandbox.h"

namespace scanlit::assignments {

/// Of the program that build() made, by Assignment::effort: what it asked for on the rubric's first
/// questions, which is the same in every run; instructions on these, where valgrind is installed
/// and works behind the sandbox's layers; the median time on questions that nobody could know.
/// Nothing where an answer is wrong. A program that knows of valgrind can make it count less: that
/// is why nothing of this gives points.
std::optional<Effort> measured_effort(const Assignment& assignment, const Rubric& rubric,
                                      sandbox::Sandbox& sandbox);

}  // namespace scanlit::assignments
