// A5: the pictures of its page, and the parts.
#include "lessons/assignments/A5_phong/parts.h"
#include "lessons/assignments/judge/registry.h"

namespace scanlit::assignments {
namespace {

using namespace phong;

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
