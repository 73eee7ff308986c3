// The mistakes that are made most with the terms and the colour forms, as formulas.
#pragma once

#include <vector>

#include "lessons/assignments/A5_phong/reference.h"

namespace scanlit::assignments::phong {

enum class Term { diffuse, phong, blinn };

std::vector<Mistake> mistakes_of(Term term, const Variant& variant, double normal_length);

/// Of one row of a colour form's question.
struct Lighting {
  Surface surface;
  Lamp lamp;
  double diffuse, glossy;
};
struct FormMistake {
  Rgb<double> (*value)(const Lighting&);
  double share;
  const char* message;
};
std::vector<FormMistake> mistakes_of_tinted();
std::vector<FormMistake> mistakes_of_plastic();

}  // namespace scanlit::assignments::phong
