// A6: what is asked, and what is said about the answers.
#include <cmath>
#include <numbers>

#include "lessons/assignments/A6_cook_torrance/mistakes.h"
#include "lessons/assignments/A6_cook_torrance/questions.h"
#include "lessons/assignments/A6_cook_torrance/reference.h"
#include "lessons/assignments/judge/model_invariants.h"
#include "lessons/assignments/judge/model_picture.h"
#include "lessons/assignments/judge/model_questions.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments {
namespace {

using namespace a6;
using namespace cook_torrance;
using std::numbers::pi;

Values of(const Rgb<double>& c) { return {c.r, c.g, c.b}; }

Finding test_m(Examination& e) {
  const Variant variant(e.variant);
  const double right = variant.m(), given = variant.given;
  const double got = ask_number(e.student, ask_m);
  if (agree(got, right, right)) return {};
  std::string why;
  if (variant.roughness == Variant::Roughness::angle && agree(got, std::tan(given), 1))
    why = " The angle is in degrees; std::tan takes radians.";
  if (agree(got, given, given)) why = " It is not m itself that is given.";
  if (agree(got, right * right, right)) why = " That is m^2.";
  return Finding::wrong(worded("The roughness is given as %g: m should be %.6g, and is %s.", given,
                               right, describe(Values{got}).c_str()) +
                        why);
}

/// L = V = H at every degree: D is a function of N.H alone.
std::vector<Directions> facing_h() {
  std::vector<Directions> all;
  for (int theta = 0; theta < 89; ++theta)
    all.push_back({direction(theta, 40), direction(theta, 40)});
  return all;
}

Finding test_D(Examination& e) {
  const Variant variant(e.variant);
  const double m = variant.m();
  Asked asked{
      .name = "D()",
      .kind = ask_D,
      .directions = seeded_directions(e.questions, 64),
      .reference = [&](const Directions& d) { return Values{variant.D_of(d.cosines().n_h, m)}; },
      .given = [m](const Directions&) { return Values{m}; }};
  const auto facing = facing_h();
  asked.directions.insert(asked.directions.begin(), facing.begin(), facing.end());
  const Finding values = compare_values(e, asked, mistakes_of_D(variant));
  if (values.share == 1) return values;
  // What the density is for, in numbers.
  asked.directions.clear();
  constexpr int steps = 180;
  for (int i = 0; i < steps; ++i) {
    const Vec3<double> h = direction((i + .5) * 90 / steps, 0);
    asked.directions.push_back({h, h});
  }
  const Values D = ask_values(e.student, asked);
  double integral = 0;
  for (int i = 0; i < steps; ++i) {
    const double alpha = (i + .5) * pi / 2 / steps;
    integral += D[std::size_t(i)] * std::cos(alpha) * std::sin(alpha) * 2 * pi * pi / 2 / steps;
  }
  Finding finding = values;
  if (variant.density && !agree(integral, 1, 50))
    finding.message += worded(
        "\nThe integral of D (N.H) over the hemisphere should be 1; yours is %.4g.", integral);
  if (!variant.density && !agree(D[0], 1, 50))
    finding.message += worded("\nD should be 1 where H is N; yours is %.4g.", D[0]);
  return finding;
}

Finding test_G(Examination& e) {
  const Variant variant(e.variant);
  const double m = variant.m();
  const Asked asked{
      .name = "G()",
      .kind = ask_G,
      .directions = seeded_directions(e.questions, 128),
      .reference = [&](const Directions& d) { return Values{variant.G_of(d.cosines(), m)}; },
      .given = [m](const Directions&) { return Values{m}; }};
  return compare_values(e, asked, mistakes_of_G(variant));
}

Finding test_F(Examination& e) {
  const Variant variant(e.variant);
  const Asked asked{
      .name = "F()",
      .kind = ask_F,
      .width = 3,
      .directions = seeded_directions(e.questions, 128),
      .reference = [&](const Directions& d) { return of(variant.F_of(d.cosines().v_h)); }};
  return compare_values(e, asked, mistakes_of_F(variant));
}

Finding test_product(Examination& e) {
  const Variant variant(e.variant);
  const auto parts = [&variant](const Directions& d) {
    const Cosines<double> c = d.cosines();
    const Rgb<double> F = variant.F_of(c.v_h);
    return Values{variant.D_of(c.n_h, variant.m()), variant.G_of(c, variant.m()), F.r, F.g, F.b};
  };
  const Asked asked{.name = "product(), of the right D, G and F,",
                    .kind = ask_product,
                    .width = 3,
                    .directions = seeded_directions(e.questions, 128),
                    .reference = [&](const Directions& d) { return of(variant.whole(d)); },
                    .given = parts};
  return compare_values(e, asked, mistakes_of_product(variant));
}

Finding test_model(Examination& e) {
  const Variant variant(e.variant);
  const Asked asked{.name = "The model",
                    .kind = ask_model,
                    .width = 3,
                    .directions = seeded_directions(e.questions, 128),
                    .reference = [&](const Directions& d) { return of(variant.whole(d)); }};
  const Finding values = compare_values(e, asked, {});
  if (values.share == 1) return values;
  const BrdfScale f_r = [&variant](const Directions& d) {
    return variant.braces ? 1 / (pi * d.l.z) : 1;
  };
  return combine(
      {{.5, values}, {.25, check_reciprocity(e, asked, f_r)}, {.25, check_albedo(e, asked, f_r)}});
}

/// What `product` or the whole model gives, in the model interface's terms.
Reflection<double> in_braces(const Variant& variant, const Directions& d,
                             const Rgb<double>& value) {
  return {.diffuse = {}, .glossy = variant.braces ? value : value * (pi * d.l.z)};
}

/// Highlights just do not reach 1, where they would lose their colour.
ModelPicture teapot(const Variant& variant) {
  const Directions mirrored{direction(30, 0), direction(30, 180)};
  const double peak = in_braces(variant, mirrored, variant.whole(mirrored)).glossy.r;
  return {.name = "A6.7-teapot", .title = "The teapot of copper", .brightness = 1 / peak};
}

std::shared_ptr<const ReflectionModel> right_model(const Variant& variant) {
  return std::make_shared<ReferenceModel>(
      [variant](const Directions& d) { return in_braces(variant, d, variant.whole(d)); });
}

Finding test_picture(Examination& e) {
  const Variant variant(e.variant);
  return compare_pictures(
      e, teapot(variant), right_model(variant),
      std::make_shared<AskedModel>(e.student, ask_picture,
                                   [variant](const Directions& d, const Reflection<double>& r) {
                                     return in_braces(variant, d, r.glossy);
                                   }));
}

std::map<std::string, JudgedPicture> illustrations(std::uint64_t seed) {
  const Variant variant(seed);
  const auto starter = std::make_shared<ReferenceModel>(
      [variant](const Directions& d) { return in_braces(variant, d, Rgb<double>(d.v.z)); });
  return {{"before.png", drawn(teapot(variant), starter)},
          {"after.png", drawn(teapot(variant), right_model(variant))}};
}

}  // namespace

Assignment a6_cook_torrance() {
  return {.id = "A6",
          .title = "Cook-Torrance",
          .folder = "A6_cook_torrance",
          .file = "cook_torrance.h",
          .header = "",
          .words = [](std::uint64_t seed) { return Variant(seed).words(); },
          .illustrations = illustrations,
          .parts = {{"A6.1", "Roughness m", test_m},
                    {"A6.2", "D, the distribution of facets", test_D},
                    {"A6.3", "G, shadowing and masking", test_G},
                    {"A6.4", "F, Fresnel's reflectance", test_F},
                    {"A6.5", "The product", test_product},
                    {"A6.6", "The model, reciprocal and bounded", test_model},
                    {"A6.7", "The picture", test_picture}}};
}

}  // namespace scanlit::assignments
