// A5.6 to A5.9: colour forms and pictures.
#include "lessons/assignments/A5_phong/parts.h"
#include "lessons/assignments/A5_phong/questions.h"
#include "lessons/assignments/judge/dice.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments::phong {

using namespace a5;

// ----------------------------------------------------------------------------------- A5.6 and A5.7

namespace {

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

}  // namespace

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
               worded("\n  Ia = %.4g, Ii = %.4g, light's colour = ", l.lamp.ambient,
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

namespace {

/// As main.cpp has them.
const Surface blue_surface{Rgb<double>(.1, .3, .6), Rgb<double>(.1, .3, .6), Rgb<double>(.5)};
const Surface red_surface{Rgb<double>(.1), Rgb<double>(.7), Rgb<double>(.5), {.9, .25, .1}};
const Lamp white_lamp{0, 1, Rgb<double>(1)};

}  // namespace

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

}  // namespace scanlit::assignments::phong
