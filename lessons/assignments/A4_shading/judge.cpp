// A4: the variant in words, and the parts.
#include "lessons/assignments/A4_shading/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments {
namespace {

using namespace shading;

Words words_of(std::uint64_t seed) {
  const ShadingVariant v = shading_variant(seed);
  const auto truth = [](bool b) { return std::string(b ? "true" : "false"); };
  return {
      {"wrap", studio::text_of(v.wrap)},
      {"mirrored", truth(v.mirrored_light)},
      {"clamps", truth(v.clamps_vertices)},
      {"unit_first", truth(v.unit_first)},
      {"highlight", v.mirrored_light ? "(R.V)^n" : "(N.H)^n"},
      {"highlight's direction",
       v.mirrored_light ? "R = 2 (N.L) N - L, the light's direction mirrored in the surface"
                        : "H = (L + V) / |L + V|, half-way between light and viewer"},
      {"clamping",
       v.clamps_vertices
           ? "each channel is then cut to 0..1, as the fixed-point colours of classical "
             "hardware were"
           : "it is not cut, however bright; only the picture is, at the end"},
      {"normals", v.unit_first
                      ? "Each vertex's normal gets unit length first; then they are interpolated, "
                        "and the result gets unit length."
                      : "The vertices' normals are interpolated as long as they are, so that a "
                        "longer one counts more; the result gets unit length."}};
}

}  // namespace

Assignment a4_shading() {
  return {.id = "A4",
          .title = "Gouraud and Phong shading",
          .folder = "A4_shading",
          .file = "shading.cpp",
          .header = "shading.h",
          .words = words_of,
          .illustrations =
              [](std::uint64_t seed) {
                const auto shown = [&](Interpolated what) {
                  const Framebuffer f = right_teapot(shading_variant(seed), what);
                  return judged("", "", f, f);
                };
                return std::map<std::string, JudgedPicture>{
                    {"before.png", shown(Interpolated::nothing)},
                    {"gouraud.png", shown(Interpolated::colours)},
                    {"phong.png", shown(Interpolated::normals)}};
              },
          .parts = {{"A4.1", "Light at a point", test_light},
                    {"A4.2", "Gouraud: a vertex", test_vertex},
                    {"A4.3", "Interpolation", test_interpolate},
                    {"A4.4", "Interpolation of normals", test_normal},
                    {"A4.5", "Phong: a fragment", test_fragment},
                    {"A4.6", "The pictures", test_pictures}}};
}

}  // namespace scanlit::assignments
