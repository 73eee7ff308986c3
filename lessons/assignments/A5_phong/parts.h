// A5's parts, and what they share.
#pragma once

#include "lessons/assignments/A5_phong/mistakes.h"
#include "lessons/assignments/judge/model_picture.h"

namespace scanlit::assignments::phong {

// parts_of_terms.cpp
Finding test_exponents(Examination& e);        // A5.1
Finding test_vectors(Examination& e);          // A5.2
Finding test_term(Examination& e, Term term);  // A5.3 to A5.5

// parts_of_colour.cpp
Finding test_form(Examination& e, bool is_tinted);     // A5.6, A5.7
Finding test_picture(Examination& e, bool is_tinted);  // A5.8, A5.9
extern const ModelPicture tinted_teapot, plastic_teapot;
std::shared_ptr<const ReflectionModel> right_model(const Variant& variant, bool is_tinted);

// parts_of_terms.cpp
Values of(const Vec3<double>& a);
Values of(const Rgb<double>& c);
void append(Values& to, const Values& more);
/// What is sent for each pair of directions: normal, light, viewer, and the right exponents.
Values ask_points(Respondent& student, int kind, int width, const Variant& variant,
                  const std::vector<Point>& points);

}  // namespace scanlit::assignments::phong
