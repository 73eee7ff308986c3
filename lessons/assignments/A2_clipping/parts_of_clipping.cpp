// A2.1 to A2.5: distances, cuts, polygons, weights.
#include <algorithm>
#include <cmath>

#include "lessons/assignments/A2_clipping/parts.h"
#include "lessons/assignments/judge/dice.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments::clipping {
namespace {

constexpr AnswerSize any_polygon{.most_reals = 7 * 64};

/// Inside or outside of any plane, in front of the eye or behind it.
Vertex any_vertex(Dice& dice) {
  const double w = dice.real(-1, 4);
  return {dice.real(-3, 3),
          dice.real(-3, 3),
          dice.real(-1, 1) * std::max(1.0, w),
          w,
          {dice.real(0, 1), dice.real(0, 1), dice.real(0, 1)}};
}

Plane any_plane(Dice& dice) { return Plane(dice.between(0, 5)); }

std::string number(double x) { return studio::fixed(x, 5); }

}  // namespace

Finding test_distance(Examination& e) {
  const ClipVariant variant = clip_variant(e.variant);
  Dice dice(e.questions, "A2.1");
  for (int i = 0; i < 60; ++i) {
    const Vertex v = any_vertex(dice);
    const Plane plane = any_plane(dice);
    Numbers question;
    put(v, question);
    question.integers = {int(plane)};
    const double got = ask(e, ask_distance, question, AnswerSize::reals(1)).reals[0];
    const double right = right_distance(variant, v, plane);
    if (std::abs(got - right) <= 1e-9) continue;
    std::string message = "distance(" + words(v) + ", " + name(plane) +
                          ")\n  yours:     " + number(got) + "\n  should be: " + number(right);
    ClipVariant whole = variant, other = variant;
    whole.window = 1, other.near_at_0 = !variant.near_at_0;
    if (std::abs(got - right_distance(whole, v, plane)) <= 1e-9)
      message += "\nThat is the side of the picture: your variant's window is smaller, " +
                 studio::text_of(variant.window) + " w.";
    else if (std::abs(got - right_distance(other, v, plane)) <= 1e-9)
      message += std::string("\nYour variant's near plane is ") +
                 (variant.near_at_0 ? "z = 0." : "z = -w.");
    else if (std::abs(got + right) <= 1e-9)
      message += "\nThe distance is positive inside.";
    return Finding::wrong(message);
  }
  return {};
}

Finding test_cut(Examination& e) {
  const ClipVariant variant = clip_variant(e.variant);
  Dice dice(e.questions, "A2.2");
  for (int i = 0; i < 30;) {
    const Vertex a = any_vertex(dice), b = any_vertex(dice);
    const Plane plane = any_plane(dice);
    const double d_a = right_distance(variant, a, plane), d_b = right_distance(variant, b, plane);
    if (d_a < 0.01 || d_b > -0.01) continue;
    ++i;
    Numbers question;
    put(a, question), put(b, question);
    question.reals.insert(question.reals.end(), {d_a, d_b});
    const Vertex got = vertex_of(ask(e, ask_cut, question, AnswerSize::reals(7)));
    const Vertex right = right_cut(a, b, d_a, d_b);
    if (equal(got, right)) continue;
    std::string message = "cut(inside " + words(a) + ",\n    outside " + words(b) + ",\n    " +
                          number(d_a) + ", " + number(d_b) + ")\n  yours:     " + words(got) +
                          "\n  should be: " + words(right);
    Vertex kept = right;
    std::copy_n(a.attribute, 3, kept.attribute);
    if (equal(got, right_cut(b, a, d_a, d_b)))
      message += "\nThe share of the way is counted from the wrong end.";
    else if (equal(got, kept))
      message += "\nAttributes change along the edge as positions do.";
    return Finding::wrong(message);
  }
  return {};
}

Finding test_clip(Examination& e) {
  const ClipVariant variant = clip_variant(e.variant);
  Dice dice(e.questions, "A2.3");
  for (int i = 0; i < 40; ++i) {
    const Plane plane = any_plane(dice);
    Polygon polygon{any_vertex(dice), any_vertex(dice), any_vertex(dice)};
    // A polygon with more corners, convex for sure: cut by another plane.
    if (i % 2) polygon = right_clip(variant, polygon, Plane((int(plane) + 3) % 6));
    if (polygon.size() < 3) continue;
    Numbers question;
    put(polygon, question);
    question.integers = {int(plane)};
    const Polygon got = polygon_of(ask(e, ask_clip, question, any_polygon));
    const Polygon right = right_clip(variant, polygon, plane);
    if (!equal(got, right))
      return Finding::wrong("clip() by the " + std::string(name(plane)) + " plane of" +
                            words(polygon) + "\n  yours:" + words(got) +
                            "\n  should be:" + words(right));
  }
  return {};
}

Finding test_triangle(Examination& e) {
  const ClipVariant variant = clip_variant(e.variant);
  Dice dice(e.questions, "A2.4");
  for (int i = 0; i < 60; ++i) {
    const Vertex triangle[3] = {any_vertex(dice), any_vertex(dice), any_vertex(dice)};
    Numbers question;
    for (const Vertex& v : triangle) put(v, question);
    const Polygon got = polygon_of(ask(e, ask_triangle, question, any_polygon));
    const Polygon right = right_pieces(variant, triangle);
    if (equal(got, right)) continue;
    std::string message = "clip_triangle() of" + words(Polygon(triangle, triangle + 3)) +
                          "\n  yours:" + words(got) + "\n  should be:" + words(right);
    for (const Vertex& v : got)
      for (const Plane plane : a2::all_planes)
        if (right_distance(variant, v, plane) < -1e-6)
          return Finding::wrong(message + "\nA vertex of yours is outside of the " + name(plane) +
                                " plane: " + words(v));
    return Finding::wrong(message);
  }
  return {};
}

Finding test_perspective(Examination& e) {
  const ClipVariant variant = clip_variant(e.variant);
  Dice dice(e.questions, "A2.5");
  for (int i = 0; i < 30; ++i) {
    const double w[3] = {dice.real(0.1, 10), dice.real(0.1, 10), dice.real(0.1, 10)};
    const double a = dice.unit(), b = dice.unit() * (1 - a);
    const Weights on_screen{{a, b, 1 - a - b}};
    Numbers question{.integers = {1}, .reals = {}};
    for (const double each : w) question.reals.push_back(variant.given_inv_w ? 1 / each : each);
    put(on_screen, question);
    const auto r = ask(e, ask_perspective, question, AnswerSize::reals(3)).reals;
    const Weights right = right_perspective(on_screen, w);
    const auto is = [&](const Weights& weights) {
      return std::abs(r[0] - weights.corner[0]) + std::abs(r[1] - weights.corner[1]) +
                 std::abs(r[2] - weights.corner[2]) <=
             1e-8;
    };
    if (is(right)) continue;
    std::string message =
        "perspective(" + words(on_screen) + ", " + (variant.given_inv_w ? "1/w " : "w ") +
        words(Weights{{question.reals[0], question.reals[1], question.reals[2]}}) +
        ")\n  yours:     " + words(Weights{{r[0], r[1], r[2]}}) + "\n  should be: " + words(right);
    if (is(on_screen))
      message += "\nThose are the weights on the screen: interpolation would be affine.";
    else if (is(right_perspective(on_screen, {1 / w[0], 1 / w[1], 1 / w[2]})))
      message += std::string("\nYour variant gives ") + (variant.given_inv_w ? "1/w." : "w.");
    else if (std::abs(r[0] + r[1] + r[2] - 1) > 1e-8)
      message += "\nWeights add up to 1.";
    return Finding::wrong(message);
  }
  return {};
}

}  // namespace scanlit::assignments::clipping
