// A3.1 to A3.5: depths one by one, and a buffer of them.
#include <algorithm>
#include <cmath>

#include "lessons/assignments/A3_visibility/parts.h"
#include "lessons/assignments/judge/dice.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments::visibility {
namespace {

std::string number(double x) { return studio::fixed(x, 6); }

std::string yours(const std::string& got, const std::string& right) {
  return "\n  yours:     " + got + "\n  should be: " + right;
}

}  // namespace

Finding test_depth_of(Examination& e) {
  const DepthVariant variant = depth_variant(e.variant);
  Dice dice(e.questions, "A3.1");
  for (int i = 0; i < 40; ++i) {
    const double near = dice.real(0.1, 2), far = near + dice.real(1, 50);
    const double share = i == 0 ? 0 : i == 1 ? 1 : dice.unit();
    const double distance = near + share * (far - near);
    const double got = e.student
                           .ask(ask_depth_of, {.integers = {}, .reals = {distance, near, far}},
                                AnswerSize::reals(1))
                           .reals[0];
    const double right = right_depth_of(variant, distance, near, far);
    if (std::abs(got - right) <= 1e-9) continue;
    std::string message = "depth_of(" + number(distance) + ", near " + number(near) + ", far " +
                          number(far) + ")" + yours(number(got), number(right));
    const double linear = variant.smaller_is_nearer ? share : 1 - share;
    if (std::abs(got - (1 - right)) <= 1e-9)
      message += std::string("\nYour variant has ") + (variant.smaller_is_nearer ? "0" : "1") +
                 " at the near plane.";
    else if (std::abs(got - linear) <= 1e-9)
      message += "\nThat is linear in the distance: on the screen it is 1 / distance that is.";
    return Finding::wrong(message);
  }
  return {};
}

Finding test_depth_at(Examination& e) {
  Dice dice(e.questions, "A3.2");
  for (int i = 0; i < 40; ++i) {
    Corner t[3];
    double area = 0;
    do {
      for (Corner& corner : t) corner = {dice.real(-50, 200), dice.real(-50, 200), dice.unit()};
      area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
    } while (std::abs(area) < 50);
    const double a = dice.unit(), b = dice.unit() * (1 - a), c = 1 - a - b;
    const double x = a * t[0].x + b * t[1].x + c * t[2].x, y = a * t[0].y + b * t[1].y + c * t[2].y;
    Numbers question;
    std::string text = "depth_at(";
    for (const Corner& corner : t) {
      question.reals.insert(question.reals.end(), {corner.x, corner.y, corner.depth});
      text += "(" + number(corner.x) + ", " + number(corner.y) + ", depth " + number(corner.depth) +
              ")\n    ";
    }
    question.reals.insert(question.reals.end(), {x, y});
    const double got = e.student.ask(ask_depth_at, question, AnswerSize::reals(1)).reals[0];
    const double right = right_depth_at(t, x, y);
    if (std::abs(got - right) <= 1e-6) continue;
    std::string message =
        text + "at " + number(x) + ", " + number(y) + ")" + yours(number(got), number(right));
    if (std::abs(got - (t[0].depth + t[1].depth + t[2].depth) / 3) <= 1e-6)
      message +=
          "\nThat is the triangle's mean depth: triangles that pass through each other want "
          "the depth at the pixel.";
    return Finding::wrong(message);
  }
  return {};
}

Finding test_stored(Examination& e) {
  const DepthVariant variant = depth_variant(e.variant);
  Dice dice(e.questions, "A3.3");
  for (int i = 0; i < 60; ++i) {
    static constexpr double limits[] = {0, 1, -0.5, 1.5};
    double depth = i < 4 ? limits[i] : dice.unit();
    // Where rounding decides, no rounding error of the product does.
    if (i >= 4) depth = (std::floor(depth * variant.most()) + (i % 2 ? 0.3 : 0.7)) / variant.most();
    const auto got =
        e.student.ask(ask_stored, {.integers = {}, .reals = {depth}}, AnswerSize::integers(1))
            .integers[0];
    const auto right = std::int64_t(right_stored(variant, depth));
    if (got == right) continue;
    std::string message = "stored(" + number(depth) + "), of 0.." + std::to_string(variant.most()) +
                          yours(std::to_string(got), std::to_string(right));
    DepthVariant other = variant;
    other.rounds = !variant.rounds;
    if (depth < 0 || depth > 1)
      message += "\nWhat leaves 0..1 is cut off.";
    else if (got == std::int64_t(right_stored(other, depth)))
      message += std::string("\nYour variant rounds ") + (variant.rounds ? "to nearest." : "down.");
    return Finding::wrong(message);
  }
  return {};
}

Finding test_replaces(Examination& e) {
  const DepthVariant variant = depth_variant(e.variant);
  Dice dice(e.questions, "A3.4");
  const auto cleared = e.student.ask(ask_farthest, {}, AnswerSize::integers(1)).integers[0];
  if (cleared != std::int64_t(right_farthest(variant)))
    return Finding::wrong("farthest(): what the buffer holds before anything is drawn" +
                          yours(std::to_string(cleared), std::to_string(right_farthest(variant))));
  for (int i = 0; i < 60; ++i) {
    const std::int64_t there = dice.between(0, int(variant.most()));
    const std::int64_t fresh = i % 3 ? dice.between(0, int(variant.most())) : there;
    const bool got =
        e.student
            .ask(ask_replaces, {.integers = {fresh, there}, .reals = {}}, AnswerSize::integers(1))
            .integers[0] != 0;
    const bool right = right_replaces(variant, StoredDepth(fresh), StoredDepth(there));
    if (got == right) continue;
    const auto word = [](bool yes) { return std::string(yes ? "yes" : "no"); };
    return Finding::wrong("replaces(" + std::to_string(fresh) + ", what is there: " +
                          std::to_string(there) + ")" + yours(word(got), word(right)) +
                          (fresh != there ? std::string("\nIn your variant ") +
                                                (variant.smaller_is_nearer ? "smaller" : "larger") +
                                                " depths are nearer."
                           : variant.last_wins ? "\nOf equal depths the last one drawn is seen."
                                               : "\nOf equal depths the first one drawn stays."));
  }
  return {};
}

namespace {

Numbers right_answer(const DepthVariant& variant, int kind, const Numbers& question) {
  const auto& n = question.integers;
  Numbers answer;
  if (kind == ask_stored && question.reals.size() == 1)
    answer.integers = {right_stored(variant, question.reals[0])};
  else if (kind == ask_farthest)
    answer.integers = {right_farthest(variant)};
  else if (kind == ask_replaces && n.size() == 2)
    answer.integers = {right_replaces(variant, StoredDepth(n[0]), StoredDepth(n[1]))};
  else
    throw Unanswered("your program asked back for what there is not");
  return answer;
}

/// What was drawn at a pixel, in order.
std::string history(const DepthVariant& variant, const std::vector<Fragment>& fragments, int column,
                    int row) {
  std::string text;
  for (const Fragment& f : fragments)
    if (f.column == column && f.row == row)
      text += "\n    fragment of " + std::to_string(f.id) + ", depth " + number(f.depth) +
              ", stored " + std::to_string(right_stored(variant, f.depth));
  return text;
}

}  // namespace

Finding test_draw(Examination& e) {
  const DepthVariant variant = depth_variant(e.variant);
  Dice dice(e.questions, "A3.5");
  constexpr int width = 7, height = 5;
  for (int i = 0; i < 6; ++i) {
    std::vector<Fragment> fragments;
    Numbers question{.integers = {width, height}, .reals = {}};
    for (int id = 0; id < 120; ++id) {
      // Few depths, so that some are equal.
      const Fragment f{dice.between(i < 3 ? 0 : -2, width - (i < 3 ? 1 : -2)),
                       dice.between(0, height - 1), dice.between(0, 6) / 6.0, id};
      fragments.push_back(f);
      question.integers.insert(question.integers.end(), {f.column, f.row, f.id});
      question.reals.push_back(f.depth);
    }
    const auto counsel = [&](int kind, const Numbers& asked) {
      return right_answer(variant, kind, asked);
    };
    const auto got =
        e.student.ask(ask_draw, question, AnswerSize::integers(width * height), counsel).integers;
    const std::vector<int> right = right_draw(variant, fragments, width, height);
    for (std::size_t pixel = 0; pixel < right.size(); ++pixel) {
      if (got[pixel] == right[pixel]) continue;
      const int column = int(pixel) % width, row = int(pixel) / width;
      const auto word = [](std::int64_t id) {
        return id < 0 ? std::string("nothing") : "fragment of " + std::to_string(id);
      };
      return Finding::wrong("draw(): at column " + std::to_string(column) + ", row " +
                            std::to_string(row) + " came, in this order," +
                            history(variant, fragments, column, row) +
                            yours(word(got[pixel]), word(right[pixel])));
    }
  }
  return {};
}

}  // namespace scanlit::assignments::visibility
