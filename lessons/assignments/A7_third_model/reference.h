// The three models that one may choose from, as a seed draws them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/model_questions.h"

namespace scanlit::assignments::third_model {

/// A model in the two steps in which it is written.
class Model {
 public:
  virtual ~Model() = default;
  /// Red, green and blue; grey where the step has one value.
  virtual Values first(const Directions& d) const = 0;
  /// f_r in 1/sr, from the first step.
  virtual Values second(const Values& first, const Directions& d) const = 0;
  virtual std::vector<Mistake> mistakes_of_first() const = 0;
};

struct Variant {
  bool braces;  // pi f_r (N.L) is returned; else f_r
  // Ward
  double ax, ay;  // as they are given
  bool angles;    // degrees whose tangents are ax and ay; else standard deviations of slopes
  int normalisation;
  Values ward_rho;
  // Lafortune: per lobe Cx, Cy, Cz and n of red, green and blue
  Values lafortune_diffuse;
  Values lobes[2][4];
  // Oren-Nayar
  double roughness;
  bool degrees;
  double constant;
  Values oren_rho;

  explicit Variant(std::uint64_t seed);
  /// 1 Ward, 2 Lafortune, 3 Oren-Nayar.
  std::unique_ptr<Model> model(int choice) const;
  Values returned(Values f_r, const Directions& d) const;
  Words words() const;
};

}  // namespace scanlit::assignments::third_model
