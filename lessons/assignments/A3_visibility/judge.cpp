// A3: the variant in words, and the parts.
#include "lessons/assignments/A3_visibility/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/registry.h"

namespace scanlit::assignments {
namespace {

using namespace visibility;

Words words_of(std::uint64_t seed) {
  const DepthVariant v = depth_variant(seed);
  const auto truth = [](bool b) { return std::string(b ? "true" : "false"); };
  return {{"smaller", truth(v.smaller_is_nearer)},
          {"bits", std::to_string(v.bits)},
          {"most", std::to_string(v.most())},
          {"rounds", truth(v.rounds)},
          {"last_wins", truth(v.last_wins)},
          {"at near", v.smaller_is_nearer ? "0" : "1"},
          {"at far", v.smaller_is_nearer ? "1" : "0"},
          {"nearer", v.smaller_is_nearer ? "smaller" : "larger"},
          {"rounding", v.rounds ? "rounded to the nearest whole number" : "rounded down"},
          {"ties", v.last_wins ? "the one drawn last is seen" : "the one drawn first stays"}};
}

}  // namespace

Assignment a3_visibility() {
  return {.id = "A3",
          .title = "Depth and visibility",
          .folder = "A3_visibility",
          .file = "visibility.cpp",
          .header = "visibility.h",
          .words = words_of,
          .illustrations =
              [](std::uint64_t seed) {
                const auto shown = [](const Framebuffer& f) { return judged("", "", f, f); };
                return std::map<std::string, JudgedPicture>{
                    {"before.png", shown(starter_picture())},
                    {"after.png", shown(right_picture(depth_variant(seed)))}};
              },
          .parts = {{"A3.1", "Depth from distance", test_depth_of},
                    {"A3.2", "Depth at a pixel", test_depth_at},
                    {"A3.3", "Stored depth", test_stored},
                    {"A3.4", "The depth test", test_replaces},
                    {"A3.5", "The depth buffer", test_draw},
                    {"A3.6", "The picture", test_picture}}};
}

}  // namespace scanlit::assignments
