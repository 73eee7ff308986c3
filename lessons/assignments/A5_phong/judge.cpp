// A5: what is asked, and what is said about the answers.
#include <cmath>
#include <numbers>

#include "lessons/assignments/A5_phong/mistakes.h"
#include "lessons/assignments/A5_phong/reference.h"
#include "lessons/assignments/judge/dice.h"
#include "lessons/assignments/judge/model_picture.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments {
namespace {

using namespace phong;

enum Kind {  // as in main.cpp
  ask_phong_exponent = 1,
  ask_blinn_exponent,
  ask_half_vector,
  ask_mirrored,
  ask_diffuse,
  ask_phong,
  ask_blinn,
  ask_tinted,
  ask_plastic,
  ask_tinted_picture,
  ask_plastic_picture
};

Values of(const Vec3<double>& a) { return {a.x, a.y, a.z}; }
Values of(const Rgb<double>& c) { return {c.r, c.g, c.b}; }
void append(Values& to, const Values& more) { to.insert(to.end(), more.begin(), more.end()); }

// ------------------------------------------------------------------------------------------- A5.1

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

Finding test_exponents(Examination& e) {
  const Variant variant(e.variant);
  return combine(
      {{1, test_exponent(e, ask_phong_exponent, "phong_exponent()", variant.phong_exponent())},
       {1, test_exponent(e, ask_blinn_exponent, "blinn_exponent()", variant.blinn_exponent())}});
}

// ----------------------------------------------------------------------------------- A5.2 to A5.5

/// What is sent for each pair of directions: normal, light, viewer, and the right exponents.
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

std::string describe_point(const Point& p) {
  return "normal = " + describe(of(p.normal)) + ", light = " + describe(of(p.light)) +
         ", viewer = " + describe(of(p.viewer));
}

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
                     ", l = " + describe(of(points[i].light));
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

Finding test_vectors(Examination& e) {
  return combine({{1, test_vector(e, true)}, {1, test_vector(e, false)}});
}

// ----------------------------------------------------------------------------------- A5.6 and A5.7

Lighting draw_lighting(Dice& dice, bool tinted) {
  const auto colour = [&dice] {
    const double r = dice.real(.1, .9), g = dice.real(.1, .9);
    return Rgb<double>(r, g, dice.real(.1, .9));
  };
  const auto reflectance = [&] { return tinted ? colour() : Rgb<double>(dice.real(.1, .9)); };
  Lighting lighting;
  lighting.surface.ka = reflectance();
  lighting.surface.kd = reflectance();
  lighting.surface.ks = reflectance();
  if (!tinted) lighting.surface.object_colour = colour();
  lighting.lamp.ambient = dice.real(.1, .5), lighting.lamp.intensity = dice.real(.5, 3);
  lighting.lamp.colour = colour();
  lighting.diffuse = dice.real(.05, 1), lighting.glossy = dice.real(.05, 1);
  return lighting;
}

Finding test_form(Examination& e, bool is_tinted) {
  Dice dice(e.questions, "colour form");
  std::vector<Lighting> all;
  Numbers question{.integers = {32}, .reals = {}};
  for (int i = 0; i < 32; ++i) {
    const Lighting l = draw_lighting(dice, is_tinted);
    for (const Rgb<double>& k : {l.surface.ka, l.surface.kd, l.surface.ks})
      append(question.reals, is_tinted ? of(k) : Values{k.r});
    if (!is_tinted) append(question.reals, of(l.surface.object_colour));
    append(question.reals, {l.lamp.ambient, l.lamp.intensity});
    append(question.reals, of(l.lamp.colour));
    append(question.reals, {l.diffuse, l.glossy});
    all.push_back(l);
  }
  Rows rows{
      .name = is_tinted ? "tinted()" : "plastic()",
      .width = 3,
      .got =
          received(e.student.ask(is_tinted ? ask_tinted : ask_plastic, question, {96, 96, 96, 96})),
      .of_what = "questions",
      .describe = [&](std::size_t i) {
        const Lighting& l = all[i];
        const auto k = [is_tinted](const Rgb<double>& c) {
          return describe(is_tinted ? of(c) : Values{c.r});
        };
        return "ka = " + k(l.surface.ka) + ", kd = " + k(l.surface.kd) +
               ", ks = " + k(l.surface.ks) +
               (is_tinted ? "" : ", object_colour = " + describe(of(l.surface.object_colour))) +
               worded(", Ia = %.4g, Ii = %.4g, light's colour = ", l.lamp.ambient,
                      l.lamp.intensity) +
               describe(of(l.lamp.colour)) +
               worded(", diffuse = %.4g, glossy = %.4g", l.diffuse, l.glossy);
      }};
  std::vector<WrongRows> wrong;
  for (const Lighting& l : all)
    append(rows.expected, of(is_tinted ? tinted(l.surface, l.lamp, l.diffuse, l.glossy)
                                       : plastic(l.surface, l.lamp, l.diffuse, l.glossy)));
  for (const FormMistake& mistake : is_tinted ? mistakes_of_tinted() : mistakes_of_plastic()) {
    wrong.push_back({{}, mistake.share, mistake.message});
    for (const Lighting& l : all) append(wrong.back().values, of(mistake.value(l)));
  }
  return compare_rows(rows, wrong);
}

// ------------------------------------------------------------------------------------------- A5.8

/// As main.cpp has them.
const Surface blue_surface{Rgb<double>(.1, .3, .6), Rgb<double>(.1, .3, .6), Rgb<double>(.5)};
const Surface red_surface{Rgb<double>(.1), Rgb<double>(.7), Rgb<double>(.5), {.9, .25, .1}};
const Lamp white_lamp{0, 1, Rgb<double>(1)};

const ModelPicture tinted_teapot{.name = "A5.8-tinted", .title = "Form 1, with Phong's term"};
const ModelPicture plastic_teapot{.name = "A5.9-plastic", .title = "Form 2, with Blinn's term"};

std::shared_ptr<const ReflectionModel> right_model(const Variant& variant, bool is_tinted) {
  return std::make_shared<ReferenceModel>([=](const Directions& d) -> Reflection<double> {
    if (is_tinted)
      return {{}, tinted(blue_surface, white_lamp, diffuse(d), phong::phong(variant, d))};
    return {{}, plastic(red_surface, white_lamp, diffuse(d), blinn(variant, d))};
  });
}

Finding test_picture(Examination& e, bool is_tinted) {
  const Variant variant(e.variant);
  const Placement placement = seeded_placement(e.questions);
  const int kind = is_tinted ? ask_tinted_picture : ask_plastic_picture;
  const auto ask = [&](const std::vector<Directions>& all) {
    std::vector<Point> points;
    for (const Directions& d : all) points.push_back(placement.point(variant, d));
    return ask_points(e.student, kind, 6, variant, points);
  };
  return compare_pictures(
      e, is_tinted ? tinted_teapot : plastic_teapot, right_model(variant, is_tinted),
      std::make_shared<AskedModel>(
          ask, [](const Directions&, const Reflection<double>& r) { return r; }));
}

std::map<std::string, JudgedPicture> illustrations(std::uint64_t seed) {
  const Variant variant(seed);
  const auto starter = std::make_shared<ReferenceModel>([](const Directions&) {
    return Reflection<double>{{}, Rgb<double>(.5)};
  });
  return {{"before.png", drawn(tinted_teapot, starter)},
          {"after_1.png", drawn(tinted_teapot, right_model(variant, true))},
          {"after_2.png", drawn(plastic_teapot, right_model(variant, false))}};
}

}  // namespace

Assignment a5_phong() {
  return {.id = "A5",
          .title = "Phong and Blinn-Phong",
          .folder = "A5_phong",
          .file = "phong.h",
          .header = "",
          .words = [](std::uint64_t seed) { return Variant(seed).words(); },
          .illustrations = illustrations,
          .parts = {
              {"A5.1", "Exponents", test_exponents},
              {"A5.2", "H and R", test_vectors},
              {"A5.3", "Diffuse term", [](Examination& e) { return test_term(e, Term::diffuse); }},
              {"A5.4", "Phong's term", [](Examination& e) { return test_term(e, Term::phong); }},
              {"A5.5", "Blinn's term", [](Examination& e) { return test_term(e, Term::blinn); }},
              {"A5.6", "Colour form 1", [](Examination& e) { return test_form(e, true); }},
              {"A5.7", "Colour form 2", [](Examination& e) { return test_form(e, false); }},
              {"A5.8", "Picture, form 1", [](Examination& e) { return test_picture(e, true); }},
              {"A5.9", "Picture, form 2", [](Examination& e) { return test_picture(e, false); }}}};
}

}  // namespace scanlit::assignments
