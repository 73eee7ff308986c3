// A2's parts, and what they share: questions in numbers, answers in words.
#pragma once

#include <string>

#include "lessons/assignments/A2_clipping/questions.h"
#include "lessons/assignments/A2_clipping/reference.h"
#include "lessons/assignments/judge/assignment.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::assignments::clipping {

using namespace a2;

// parts_of_clipping.cpp
Finding test_distance(Examination& e);     // A2.1
Finding test_cut(Examination& e);          // A2.2
Finding test_clip(Examination& e);         // A2.3
Finding test_triangle(Examination& e);     // A2.4
Finding test_perspective(Examination& e);  // A2.5

// parts_of_a_picture.cpp
Finding test_picture(Examination& e);  // A2.6
Framebuffer right_floor(const ClipVariant& variant);
Framebuffer starter_floor();  // whole triangles where no corner is behind the eye, and affine

// parts_asking.cpp
Vertex vertex_of(const Numbers& answer, std::size_t number = 0);
Polygon polygon_of(const Numbers& answer);
std::string words(const Vertex& v);   // "(x 1, y 0, z .5, w 1; 0, .5, 0)"
std::string words(const Polygon& p);  // a line each
std::string words(const Weights& w);
const char* name(Plane plane);

bool equal(const Vertex& a, const Vertex& b);
/// The same border, wherever it begins, and however often a vertex is repeated.
bool equal(Polygon a, Polygon b);

/// What the function asks back of earlier parts is answered as the variant has it.
Numbers ask(Examination& e, int kind, const Numbers& question, const AnswerSize& size);

}  // namespace scanlit::assignments::clipping
