// What is drawn, asked and said in the parts of A4.
#include <algorithm>
#include <cmath>

#include "lessons/assignments/A4_shading/parts.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments::shading {

std::string words(Vector v, int decimals) {
  return "(" + studio::fixed(v.x, decimals) + ", " + studio::fixed(v.y, decimals) + ", " +
         studio::fixed(v.z, decimals) + ")";
}

std::string yours_and_right(const char* before_yours, Vector yours, const char* before_right,
                            Vector right) {
  const int most = 9;
  const bool same = words(yours, most) == words(right, most);
  int decimals = 4;
  while (!same && words(yours, decimals) == words(right, decimals)) ++decimals;
  return before_yours + words(yours, decimals) + before_right + words(right, decimals);
}

namespace {

Vector vector_of(const Numbers& answer) {
  return {answer.reals[0], answer.reals[1], answer.reals[2]};
}

/// Below rounding errors of any order of the operations; far below what a picture shows.
bool equal(Vector a, Vector b) {
  const Vector d = a - b;
  return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= 1e-6;
}

/// What the student's function asks back, while it is judged alone.
Numbers right_answer(const ShadingVariant& variant, int kind, const Numbers& question) {
  const auto& r = question.reals;
  const auto vector = [&](std::size_t i) { return Vector{r[3 * i], r[3 * i + 1], r[3 * i + 2]}; };
  Numbers answer;
  if (kind == ask_light && r.size() >= 17 && (r.size() - 17) % 6 == 0) {
    Scene scene{vector(2), {}, vector(3), vector(4), r[15], r[16]};
    for (std::size_t i = 17; i < r.size(); i += 6)
      scene.lights.push_back({{r[i], r[i + 1], r[i + 2]}, {r[i + 3], r[i + 4], r[i + 5]}});
    put(right_light(variant, vector(0), vector(1), scene), answer);
  } else if ((kind == ask_interpolate || kind == ask_normal) && r.size() == 12) {
    const Weights weights{{r[9], r[10], r[11]}};
    put(kind == ask_normal ? right_normal(variant, {vector(0), vector(1), vector(2)}, weights)
                           : right_between({vector(0), vector(1), vector(2)}, weights),
        answer);
  } else {
    throw Unanswered("your program asked back for what there is not");
  }
  for (double& number : answer.reals)
    if (!std::isfinite(number)) number = 0;  // of a vector without length
  return answer;
}

}  // namespace

Vector ask(Examination& e, int kind, const Numbers& question) {
  const auto counsel = [&](int asked, const Numbers& numbers) {
    if (asked >= kind) throw Unanswered("your program asks back what it is asked itself");
    return right_answer(shading_variant(e.variant), asked, numbers);
  };
  return vector_of(e.student.ask(kind, question, AnswerSize::reals(3), counsel));
}

Vector any_direction(Dice& dice) {
  for (;;) {
    const Vector v{dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1)};
    if (dot(v, v) > 0.01 && dot(v, v) <= 1) return unit(v);
  }
}

Colour any_colour(Dice& dice, double least, double most) {
  return {dice.real(least, most), dice.real(least, most), dice.real(least, most)};
}

Scene any_scene(Dice& dice, double brightness) {
  Scene scene{{dice.real(-1, 1), dice.real(-1, 1), dice.real(3, 6)},
              {},
              any_colour(dice, 0, 0.1),
              any_colour(dice, 0.1, 0.9),
              dice.real(0.2, 0.8),
              double(dice.between(1, 30))};
  for (int i = dice.between(1, 3); i > 0; --i)
    scene.lights.push_back({any_direction(dice), any_colour(dice, 0.1, brightness)});
  return scene;
}

Vertex any_vertex(Dice& dice) {
  return {{dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1)},
          dice.real(0.2, 3) * unit(any_direction(dice) + Vector{0, 0, 1.2})};
}

Weights any_weights(Dice& dice) {
  const double a = dice.unit(), b = dice.unit() * (1 - a);
  return {{a, b, 1 - a - b}};
}

Finding compare(const std::string& question, Vector got, Vector right,
                const std::vector<Mistake>& mistakes) {
  if (equal(got, right)) return {};
  std::string message =
      question + yours_and_right("\n  yours:     ", got, "\n  should be: ", right);
  for (const Mistake& mistake : mistakes)
    if (equal(got, mistake.result) && !equal(right, mistake.result)) {
      message += std::string("\n") + mistake.hint;
      break;
    }
  return Finding::wrong(message);
}

std::string describe(const Scene& scene) {
  std::string text = "  kd " + words(scene.kd) + ", ks " + studio::fixed(scene.ks, 4) + ", n " +
                     studio::text_of(scene.n) + ", ambient " + words(scene.ambient);
  for (const Light& light : scene.lights)
    text += "\n  light from " + words(light.to_light) + ", colour " + words(light.colour);
  return text;
}

}  // namespace scanlit::assignments::shading
