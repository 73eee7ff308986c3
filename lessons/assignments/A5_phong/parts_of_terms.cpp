// A5.1 to A5.5: exponents and terms.
#include <cmath>

#include "lessons/assignments/A5_phong/parts.h"
#include "lessons/assignments/A5_phong/questions.h"
#include "lessons/assignments/judge/dice.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments::phong {

using namespace a5;

Values of(const Vec3<double>& a) { return {a.x, a.y, a.z}; }
Values of(const Rgb<double>& c) { return {c.r, c.g, c.b}; }
void append(Values& to, const Values& more) { to.insert(to.end(), more.begin(), more.end()); }

// ------------------------------------------------------------------------------------------- A5.1

namespace {

Finding test_exponent(Examination& e, int kind, const char* name, double right) {
  const Variant variant(e.variant);
  const double got = ask_number(e.student, kind);
  if (agree(got, right, right)) return {};
  std::string why;
  if (agree(got, 4 * right, right)) why = " It is 4 times too large.";
  if (agree(got, right / 4, right)) why = " It is 4 times too small.";
  if (variant.given_as == Variant::Shininess::half_width &&
      agree(got, std::log(.5) / std::log(std::cos(variant.given)), right))
    why = " The angle is in degrees; std::cos takes radians.";
  if (agree(got, variant.given, right)) why = " It is not the exponent itself that is given.";
  return Finding::wrong(worded("Shininess %g is given: %s should be %.6g, and is %s.",
                               variant.given, name, right, describe(Values{got}).c_str()) +
                        why);
}

}  // namespace

Finding test_exponents(Examination& e) {
  const Variant variant(e.variant);
  return combine(
      {{1, test_exponent(e, ask_phong_exponent, "phong_exponent()", variant.phong_exponent())},
       {1, test_exponent(e, ask_blinn_exponent, "blinn_exponent()", variant.blinn_exponent())}});
}

// ----------------------------------------------------------------------------------- A5.2 to A5.5

Values ask_points(Respondent& student, int kind, int width, const Variant& variant,
                  const std::vector<Point>& points) {
  Numbers question{.integers = {std::int64_t(points.size())}, .reals = {}};
  for (const Point& p : points) {
    for (const Vec3<double>& a : {p.normal, p.light, p.viewer}) append(question.reals, of(a));
    append(question.reals, {variant.phong_exponent(), variant.blinn_exponent()});
  }
  const std::size_t count = points.size() * std::size_t(width);
  return received(student.ask(kind, question, {count, count, count, count}));
}

namespace {

std::string describe_point(const Point& p) {
  return "normal = " + describe(of(p.normal)) + "\n  light = " + describe(of(p.light)) +
         "\n  viewer = " + describe(of(p.viewer));
}

}  // namespace

Finding test_term(Examination& e, Term term) {
  const Variant variant(e.variant);
  const Placement placement = seeded_placement(e.questions);
  std::vector<Directions> all = seeded_directions(e.questions, 64);
  Dice dice(e.questions, "below the horizon");
  for (int i = 0; i < 16; ++i)
    all.push_back({direction(dice.real(95, 150), dice.real(0, 360)),
                   direction(dice.real(5, 85), dice.real(0, 360))});
  std::vector<Point> points;
  for (const Directions& d : all) points.push_back(placement.point(variant, d));

  const auto right = [&](const Directions& d) {
    return term == Term::diffuse ? diffuse(d)
           : term == Term::phong ? phong::phong(variant, d)
                                 : blinn(variant, d);
  };
  const int kinds[] = {ask_diffuse, ask_phong, ask_blinn};
  const char* const names[] = {"diffuse()", "phong()", "blinn()"};
  Rows rows{.name = names[int(term)],
            .got = ask_points(e.student, kinds[int(term)], 1, variant, points),
            .of_what = "points",
            .describe = [&](std::size_t i) {
              return describe_point(points[i]) + "\n  that is, " + describe(all[i]);
            }};
  for (const Directions& d : all) rows.expected.push_back(right(d));
  std::vector<WrongRows> wrong;
  for (const Mistake& mistake : mistakes_of(term, variant, placement.normal_length)) {
    wrong.push_back({{}, mistake.share, mistake.message});
    for (const Directions& d : all) append(wrong.back().values, mistake.value(d));
  }
  return compare_rows(rows, wrong);
}

namespace {

/// H or R, of a unit normal and a direction to the light.
Finding test_vector(Examination& e, bool half) {
  Variant variant(e.variant);
  variant.light_travels = false;
  Placement placement = seeded_placement(e.questions);
  placement.normal_length = 1;
  std::vector<Point> points;
  for (const Directions& d : seeded_directions(e.questions, 48))
    points.push_back(placement.point(variant, d));
  Rows rows{.name = half ? "half_vector()" : "mirrored()",
            .width = 3,
            .got = ask_points(e.student, half ? ask_half_vector : ask_mirrored, 3, variant, points),
            .of_what = "questions",
            .describe = [&](std::size_t i) {
              return (half ? "v = " + describe(of(points[i].viewer))
                           : "n = " + describe(of(points[i].normal))) +
                     "\n  l = " + describe(of(points[i].light));
            }};
  std::vector<WrongRows> wrong(2);
  for (const Point& p : points) {
    const Vec3<double> right = half ? unit(p.light + p.viewer) : mirrored(p.normal, p.light);
    append(rows.expected, of(right));
    append(wrong[0].values, of(half ? (p.light + p.viewer) * .5 : -right));
    append(wrong[1].values,
           of(half ? p.light + p.viewer : dot(p.normal, p.light) * p.normal - p.light));
  }
  wrong[0].share = wrong[1].share = .4;
  wrong[0].message = half ? "It is not of unit length: (L + V) / |L + V|." : "Its sign is wrong.";
  wrong[1].message = half ? "It is not of unit length: (L + V) / |L + V|."
                          : "The factor 2 is missing: R = 2 (N.L) N - L.";
  return compare_rows(rows, wrong);
}

}  // namespace

Finding test_vectors(Examination& e) {
  return combine({{1, test_vector(e, true)}, {1, test_vector(e, false)}});
}

}  // namespace scanlit::assignments::phong
