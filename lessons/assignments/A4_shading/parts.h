// A4's parts, and what they share: questions in numbers, answers in words.
#pragma once

#include <string>
#include <vector>

#include "lessons/assignments/A4_shading/questions.h"
#include "lessons/assignments/A4_shading/reference.h"
#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/dice.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::assignments::shading {

using namespace a4;

Finding test_light(Examination& e);  // A4.1, parts_of_a_point.cpp

// parts_of_a_triangle.cpp
Finding test_vertex(Examination& e);       // A4.2
Finding test_interpolate(Examination& e);  // A4.3
Finding test_normal(Examination& e);       // A4.4
Finding test_fragment(Examination& e);     // A4.5

// parts_of_a_picture.cpp
Finding test_pictures(Examination& e);  // A4.6
enum class Interpolated { nothing, colours, normals };
/// The teapot as it should be; of which nothing is interpolated, as the starter draws it.
Framebuffer right_teapot(const ShadingVariant& variant, Interpolated what);

// parts_asking.cpp
Vector any_direction(Dice& dice);
Colour any_colour(Dice& dice, double least, double most);
/// In front of the point and behind it, one to three lights.
Scene any_scene(Dice& dice, double brightness = 0.6);
Vertex any_vertex(Dice& dice);  // near the origin, its normal of any length
Weights any_weights(Dice& dice);

std::string words(Vector v, int decimals = 4);  // "(0.2500, 0.0000, -1.0000)"
/// Each after its words, with as many decimals as show that they differ.
std::string yours_and_right(const char* before_yours, Vector yours, const char* before_right,
                            Vector right);
std::string describe(const Scene& scene);

/// Three numbers; what the function asks back of earlier parts is answered as the variant has it.
Vector ask(Examination& e, int kind, const Numbers& question);

/// A mistake that many make, and what it gives.
struct Mistake {
  const char* hint;
  Vector result;
};
Finding compare(const std::string& question, Vector got, Vector right,
                const std::vector<Mistake>& mistakes);

}  // namespace scanlit::assignments::shading
