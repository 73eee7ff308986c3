// A verdict for the eyes of who handed in.
#pragma once

#include <ostream>
#include <string>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/verdict.h"

namespace scanlit::assignments {

/// Tests, points, and below each failure what is wrong, for a terminal. Of a hidden test name and
/// points only.
void print_report(std::ostream& out, const Assignment& assignment, const Verdict& verdict);

/// The same as a page, with the pictures: Yours / Should be / Difference, a slider between the
/// first two, and zoom. One file that needs no other.
std::string report_page(const Assignment& assignment, const Verdict& verdict);

/// A line about what a right program has done.
std::string effort_text(const Effort& effort);

/// 7.5, 20
std::string points_text(double points);

}  // namespace scanlit::assignments
