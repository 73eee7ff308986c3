// A7: what is asked, and what is said about the answers.
#include <cmath>
#include <numbers>

#include "lessons/assignments/A7_third_model/questions.h"
#include "lessons/assignments/A7_third_model/reference.h"
#include "lessons/assignments/judge/model_invariants.h"
#include "lessons/assignments/judge/model_picture.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments {
namespace {

using namespace a7;
using namespace third_model;

constexpr const char* names[] = {"", "Ward's", "Lafortune's", "Oren's and Nayar's"};

/// Everything that a part needs; which model it is, the student says.
struct Question {
  Variant variant;
  int choice;
  std::shared_ptr<const Model> model;

  explicit Question(Examination& e) : variant(e.variant) {
    const double chosen = ask_number(e.student, ask_choice);
    if (!(chosen == 1 || chosen == 2 || chosen == 3))
      throw Unanswered("choice must be Choice::ward, Choice::lafortune or Choice::oren_nayar");
    choice = int(chosen);
    model = variant.model(choice);
  }

  Values whole(const Directions& d) const {
    return variant.returned(model->second(model->first(d), d), d);
  }
  Asked asked(Examination& e, const char* function, int kind) const {
    return {.name = std::string(function) + " of " + names[choice] + " model",
            .kind = kind,
            .width = 3,
            .directions = seeded_directions(e.questions, 128),
            .reference = {}};
  }
};

Finding test_first(Examination& e) {
  const Question q(e);
  Asked asked = q.asked(e, "first()", ask_first);
  asked.reference = [&](const Directions& d) { return q.model->first(d); };
  return compare_values(e, asked, q.model->mistakes_of_first());
}

Finding test_second(Examination& e) {
  const Question q(e);
  Asked asked = q.asked(e, "second(), of the right first(),", ask_second);
  asked.given = [&](const Directions& d) { return q.model->first(d); };
  asked.reference = [&](const Directions& d) { return q.model->second(q.model->first(d), d); };
  return compare_values(e, asked, {});
}

Finding test_returned(Examination& e) {
  const Question q(e);
  Asked asked = q.asked(e, "returned(), of the right f_r,", ask_returned);
  asked.given = [&](const Directions& d) { return q.model->second(q.model->first(d), d); };
  asked.reference = [&](const Directions& d) { return q.whole(d); };
  return compare_values(e, asked, {});
}

/// Where formulas divide 0 by 0: L = V = N, L = V, both at grazing angles.
std::vector<Directions> limits() {
  std::vector<Directions> all;
  for (const double theta : {0., 1e-4, 1., 45., 89., 89.9})
    for (const double phi : {0., 90., 180., 217.})
      all.push_back({direction(theta, 30), direction(theta, 30 + phi)});
  for (const double theta : {30., 89.9}) {
    all.push_back({direction(0, 0), direction(theta, 60)});
    all.push_back({direction(theta, 60), direction(0, 0)});
  }
  return all;
}

Finding test_limits(Examination& e) {
  const Question q(e);
  Asked asked = q.asked(e, "At the limits, the whole", ask_model);
  asked.directions = limits();
  asked.reference = [&](const Directions& d) { return q.whole(d); };
  return compare_values(e, asked, {});
}

Finding test_model(Examination& e) {
  const Question q(e);
  Asked asked = q.asked(e, "The whole", ask_model);
  asked.reference = [&](const Directions& d) { return q.whole(d); };
  const Finding values = compare_values(e, asked, {});
  if (values.share == 1) return values;
  const BrdfScale f_r = [&q](const Directions& d) {
    return q.variant.braces ? 1 / (std::numbers::pi * d.l.z) : 1;
  };
  return combine(
      {{.5, values}, {.25, check_reciprocity(e, asked, f_r)}, {.25, check_albedo(e, asked, f_r)}});
}

Reflection<double> in_braces(const Variant& variant, const Directions& d, const Values& v) {
  const double scale = variant.braces ? 1 : std::numbers::pi * d.l.z;
  return {.diffuse = {}, .glossy = {v[0] * scale, v[1] * scale, v[2] * scale}};
}

ModelPicture brushed_teapot() {
  return {.name = "A7.6-teapot", .title = "The teapot, brushed in circles"};
}

Finding test_picture(Examination& e) {
  const Question q(e);
  return compare_pictures(
      e, brushed_teapot(), std::make_shared<ReferenceModel>([&](const Directions& d) {
        return in_braces(q.variant, d, q.whole(d));
      }),
      std::make_shared<AskedModel>(
          e.student, ask_picture, [&](const Directions& d, const Reflection<double>& r) {
            return in_braces(q.variant, d, {r.glossy.r, r.glossy.g, r.glossy.b});
          }));
}

std::map<std::string, JudgedPicture> illustrations(std::uint64_t seed) {
  const Variant variant(seed);
  std::map<std::string, JudgedPicture> all;
  const char* const files[] = {"before.png", "ward.png", "lafortune.png", "oren_nayar.png"};
  for (int choice = 0; choice <= 3; ++choice) {
    const std::shared_ptr<const Model> model = variant.model(choice);
    all[files[choice]] = drawn(
        brushed_teapot(), std::make_shared<ReferenceModel>([&](const Directions& d) {
          const double n_v = d.v.z;
          if (choice == 0) return in_braces(variant, d, Values(3, n_v * n_v));
          return in_braces(variant, d, variant.returned(model->second(model->first(d), d), d));
        }));
  }
  return all;
}

}  // namespace

Assignment a7_third_model() {
  return {.id = "A7",
          .title = "Anisotropic, fitted or rough",
          .folder = "A7_third_model",
          .file = "third_model.h",
          .header = "",
          .words = [](std::uint64_t seed) { return Variant(seed).words(); },
          .illustrations = illustrations,
          .parts = {{"A7.1", "The first step", test_first},
                    {"A7.2", "f_r", test_second},
                    {"A7.3", "What is returned", test_returned},
                    {"A7.4", "The limits", test_limits},
                    {"A7.5", "The model, reciprocal", test_model},
                    {"A7.6", "The picture", test_picture}}};
}

}  // namespace scanlit::assignments
