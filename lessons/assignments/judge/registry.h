// Every assignment, one line each, in order; assignments.cpp calls them.
#pragma once

#include "lessons/assignments/judge/assignment.h"

namespace scanlit::assignments {

Assignment a1_scan_conversion();
Assignment a2_clipping();
Assignment a3_visibility();
Assignment a4_shading();
Assignment a5_phong();
Assignment a6_cook_torrance();
Assignment a7_third_model();
Assignment a8_less_work();
Assignment a9_mutant_hunt();

}  // namespace scanlit::assignments
