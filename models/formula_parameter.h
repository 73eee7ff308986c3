// A formula's parameters: which member holds which, so that one description serves the constant
// formula, the one whose parameters vary, and the lists that people read.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "models/parameter.h"

namespace scanlit::models {

/// Formula<double> and its like for other types of parameters; see models/formula.h.
template <class Formula>
struct WithParameters {
  using Type = double;
  static constexpr bool can_vary = false;
};
template <template <class> class Formula, class P>
struct WithParameters<Formula<P>> {
  using Type = P;
  static constexpr bool can_vary = true;
  template <class T>
  using Of = Formula<T>;
};
template <class Formula>
constexpr bool can_vary = WithParameters<Formula>::can_vary;

/// A parameter of a formula: its key, the member that holds it, what is allowed, its meaning. The
/// member's initial value is the default. The member's type says what it is: P a number, Rgb<P> a
/// colour, Vec3<P> a direction in the shading frame, int a choice (the index of its word).
template <class Formula>
class Parameter {
 public:
  using P = typename WithParameters<Formula>::Type;
  using Number = P Formula::*;
  using Colour = Rgb<P> Formula::*;
  using Direction = Vec3<P> Formula::*;
  using Choice = int Formula::*;

  Parameter(std::string k, Number m, double least, double most, std::string what,
            std::string with = "")
      : key(std::move(k)),
        min(least),
        max(most),
        meaning(std::move(what)),
        only_with(std::move(with)),
        member_(m) {}
  Parameter(std::string k, Colour m, double least, double most, std::string what,
            std::string with = "")
      : key(std::move(k)),
        min(least),
        max(most),
        meaning(std::move(what)),
        only_with(std::move(with)),
        member_(m) {}
  Parameter(std::string k, Direction m, std::string what, std::string with = "")
      : key(std::move(k)),
        min(-1),
        max(1),
        meaning(std::move(what)),
        only_with(std::move(with)),
        member_(m) {}
  Parameter(std::string k, Choice m, std::vector<std::string> words, std::string what,
            std::string with = "")
      : key(std::move(k)),
        choices(std::move(words)),
        meaning(std::move(what)),
        only_with(std::move(with)),
        member_(m) {}

  const Number* number() const { return std::get_if<Number>(&member_); }
  const Colour* colour() const { return std::get_if<Colour>(&member_); }
  const Direction* direction() const { return std::get_if<Direction>(&member_); }
  const Choice* choice() const { return std::get_if<Choice>(&member_); }
  std::size_t channels() const { return number() ? 1 : choice() ? 0 : 3; }

  std::string key;
  double min = 0, max = 0;
  std::vector<std::string> choices;
  std::string meaning, only_with;

 private:
  std::variant<Number, Colour, Direction, Choice> member_;
};

/// Sets a constant parameter from a value that was checked.
template <class Formula>
void assign(Formula& formula, const Parameter<Formula>& p, const Value& value) {
  if (const auto* number = p.number()) formula.** number = std::get<double>(value);
  if (const auto* colour = p.colour()) formula.** colour = std::get<Rgb<double>>(value);
  if (const auto* direction = p.direction()) formula.** direction = std::get<Vec3<double>>(value);
  if (const auto* choice = p.choice()) {
    const auto& words = p.choices;
    const auto found = std::find(words.begin(), words.end(), std::get<std::string>(value));
    formula.** choice = int(found - words.begin());
  }
}

}  // namespace scanlit::models
