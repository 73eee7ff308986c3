// A2: the variant in words, and the parts.
#include "lessons/assignments/A2_clipping/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments {
namespace {

using namespace clipping;

Words words_of(std::uint64_t seed) {
  const ClipVariant v = clip_variant(seed);
  const auto truth = [](bool b) { return std::string(b ? "true" : "false"); };
  return {{"window", studio::text_of(v.window)},
          {"near_at_0", truth(v.near_at_0)},
          {"given_inv_w", truth(v.given_inv_w)},
          {"near", v.near_at_0 ? "0" : "-w"},
          {"given", v.given_inv_w ? "1/w" : "w"}};
}

}  // namespace

Assignment a2_clipping() {
  return {.id = "A2",
          .title = "Clipping and perspective",
          .folder = "A2_clipping",
          .file = "clipping.cpp",
          .header = "clipping.h",
          .words = words_of,
          .illustrations =
              [](std::uint64_t seed) {
                const auto shown = [](const Framebuffer& f) { return judged("", "", f, f); };
                return std::map<std::string, JudgedPicture>{
                    {"before.png", shown(starter_floor())},
                    {"after.png", shown(right_floor(clip_variant(seed)))}};
              },
          .parts = {{"A2.1", "Distance to a plane", test_distance},
                    {"A2.2", "Cutting an edge", test_cut},
                    {"A2.3", "Clipping by one plane", test_clip},
                    {"A2.4", "Clipping a triangle", test_triangle},
                    {"A2.5", "Perspective", test_perspective},
                    {"A2.6", "The picture", test_picture}}};
}

}  // namespace scanlit::assignments
