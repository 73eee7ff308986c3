// A1's parts, and what they share: questions in numbers, answers in words.
#pragma once

#include <string>
#include <vector>

#include "lessons/assignments/A1_scan_conversion/questions.h"
#include "lessons/assignments/A1_scan_conversion/reference.h"
#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/dice.h"

namespace scanlit::assignments::scan {

// parts_of_a_triangle.cpp
Finding test_edge(Examination& e);    // A1.1
Finding test_owns(Examination& e);    // A1.2
Finding test_covers(Examination& e);  // A1.3
Finding test_span(Examination& e);    // A1.4

// parts_of_a_surface.cpp
Finding test_scan_convert(Examination& e);  // A1.5

/// Fragments of the student's scan_convert(): with the judge's own earlier stages, or with all the
/// student's. At most twice as many as the picture has pixels.
std::vector<a1::Fragment> ask_fragments(Respondent& student, const ScanVariant& variant,
                                        const a1::Triangle& t, const a1::Picture& picture,
                                        bool alone);
/// What is to be said of a fragment outside of the picture; empty for any other.
std::string outside(const a1::Fragment& f, const a1::Picture& picture);

// parts_of_a_picture.cpp
Finding test_picture(Examination& e);  // A1.6
Framebuffer right_teapot(const ScanVariant& variant);
Framebuffer box_teapot();  // by each triangle's box: what the starter draws

std::string words(a1::Point p);                   // "(256, 0)"
std::string words(const a1::Triangle& t);         // "(256, 0) (512, 128) (0, 0)"
std::string rule_of(const ScanVariant& variant);  // "bottom-right"

/// Corners on a raster of half pixels: many centres lie exactly on edges, and at corners.
a1::Triangle coarse_triangle(Dice& dice, int low, int high);

}  // namespace scanlit::assignments::scan
