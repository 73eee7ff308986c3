// A formula of directions is asked for its values, and they are compared with the right ones: where
// do they differ first, and does the difference look like a mistake that is often made?
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lessons/assignments/judge/assignment.h"
#include "rasterizer/cosines.h"
#include "rasterizer/vec.h"

namespace scanlit::assignments {

/// Unit, in the shading frame (x tangent, y bitangent, z normal), both above the surface.
struct Directions {
  Vec3<double> l, v;

  Cosines<double> cosines() const { return scanlit::cosines({0, 0, 1}, l, v); }
  ShadingFrame<double> frame() const { return shading_frame<double>({0, 0, 1}, {1, 0, 0}, l, v); }
};

/// Angles in degrees, from the normal and about it.
Vec3<double> direction(double theta_deg, double phi_deg);

/// From all over the hemisphere; in turn any two, near each other's mirror direction, light at
/// grazing angles, viewer at grazing angles.
std::vector<Directions> seeded_directions(std::uint64_t seed, int count);

using Values = std::vector<double>;

/// What is asked: `width` numbers for each pair of directions.
struct Asked {
  std::string name;  // as messages call it: "D"
  int kind = 0;      // of the question: see the assignment's main.cpp
  int width = 1;
  std::vector<Directions> directions;
  std::function<Values(const Directions&)> reference;
  std::function<Values(const Directions&)> given{};  // sent along with each pair
};

/// A wrong formula that is met often.
struct Mistake {
  std::function<Values(const Directions&)> value;
  double share;         // of the points that it deserves
  std::string message;  // what is wrong with it
};

/// Rows of `width` numbers: what should be and what came.
struct Rows {
  std::string name;  // as messages call it
  int width = 1;
  Values expected{}, got{};
  std::string of_what{};                             // "pairs of directions"
  std::function<std::string(std::size_t)> describe;  // of a row's question
};
struct WrongRows {
  Values values;
  double share;
  std::string message;
};

/// Where they differ first, and as which of the wrong ones.
Finding compare_rows(const Rows& rows, const std::vector<WrongRows>& mistakes);

/// The student's values, row by row; NaN and infinities among them. Throws Unanswered.
Values ask_values(Respondent& student, const Asked& asked);

/// What answer/model.h's put() sends: NaN and infinities are told apart by whole numbers beside.
Values received(Numbers answer);

/// The one number that answers a question without directions.
double ask_number(Respondent& student, int kind);

/// Within .01 % of each other, or 1e-8 of `scale`; or both NaN.
bool agree(double a, double b, double scale);

/// Asks and compares; a mistake is also recognised where all values are off by a factor such as pi
/// or N.L. Throws Unanswered.
Finding compare_values(Examination& e, const Asked& asked, const std::vector<Mistake>& mistakes);

/// "L at 30.0 degrees from N ..., N.L = 0.866, ..."
std::string describe(const Directions& directions);
std::string describe(const Values& row);

/// Findings of one part: shares weighted, messages one after the other.
Finding combine(const std::vector<std::pair<double, Finding>>& weighted);

}  // namespace scanlit::assignments
