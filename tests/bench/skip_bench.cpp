// What each switch of what is skipped (Skips in rasterizer/render.h) saves: the time of a frame
// with the switch off over the time with all on, frame by frame in turn, two threads; and whether
// both pictures, depths and ids are the same to the bit.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "bench_main.h"
#include "report.h"
#include "scanlit_side.h"
#include "skip_scenes.h"
#include "tests/unit/same_picture.h"
#include "timing.h"

namespace scanlit::bench {
namespace {

constexpr int threads = 2;

/// One way to turn something off. `nothing` shows what the measurement itself is good for; `reuse`
/// is one only in the scenes that have it on.
struct Switch {
  std::string name;
  std::function<void(RenderSettings&)> turn_off;
};

std::vector<Switch> switches() {
  std::vector<Switch> all = {{"nothing", [](RenderSettings&) {}}};
  for (const SkipSwitch& skip : skip_switches())
    all.push_back({skip.name, [&skip](RenderSettings& s) { s.skips.*skip.member = false; }});
  all.push_back({"reuse", [](RenderSettings& s) { s.reuse = false; }});
  return all;
}

/// Draws with its own settings, and keeps its own memory.
struct Side {
  RenderSettings settings;
  Framebuffer picture;
  Renderer renderer{};
  Times times{};

  void draw(SkipScene& scene) { renderer.render(scene.scene, scene.camera, settings, picture); }
};

/// Of two successive frames, in colours of full precision, with all planes that a switch may touch.
bool same_picture(SkipScene& scene, const RenderSettings& off) {
  const Planes planes{.depth = true, .ids = true};
  Side sides[] = {{scene.settings, {picture_width, picture_height, planes}},
                  {off, {picture_width, picture_height, planes}}};
  bool same = true;
  for (int frame = 0; frame < 2; ++frame) {
    pose(scene.bench, frame, scene.scene, scene.camera);
    for (Side& side : sides) side.draw(scene);
    same &= test::planes_that_differ(sides[0].picture, sides[1].picture).empty();
  }
  return same;
}

nlohmann::json measure_switch(SkipScene& scene, const Switch& to_turn, const Effort& effort) {
  RenderSettings off = scene.settings;
  to_turn.turn_off(off);
  const bool same = same_picture(scene, off);

  Side sides[] = {{scene.settings, {picture_width, picture_height, picture_planes}},
                  {off, {picture_width, picture_height, picture_planes}}};
  for (Side& side : sides) side.draw(scene);  // warm
  std::vector<double> ratios;
  repeat(effort, [&](int round) {
    pose(scene.bench, 2 + round, scene.scene, scene.camera);
    for (int turn = 0; turn < 2; ++turn) {
      Side& side = sides[(turn + round) % 2];
      side.times.measure([&] { side.draw(scene); });
    }
    ratios.push_back(sides[1].times.last_ms() / sides[0].times.last_ms());
  });
  std::ranges::sort(ratios);
  const double lower = ratios[ratios.size() / 4], upper = ratios[ratios.size() * 3 / 4];
  return {{"scene", scene.bench.name},
          {"switch", to_turn.name},
          {"threads", threads},
          {"scanlit_ms", sides[0].times.summary().median_ms},
          {"off_ms", sides[1].times.summary().median_ms},
          {"ratio", median(ratios)},
          {"quartiles", {lower, upper}},
          {"within_noise", lower <= 1 && 1 <= upper},
          {"same_picture", same}};
}

std::string cell(const nlohmann::json& r) {
  if (!r["same_picture"]) return "differs";
  char text[16];
  std::snprintf(text, sizeof text, "%.2f", r["ratio"].get<double>());
  return r["within_noise"] || text == std::string("1.00") ? "" : text;
}

void print_table(const std::vector<std::string>& scenes,
                 const std::map<std::string, std::map<std::string, nlohmann::json>>& results) {
  std::printf(
      "\ntime with the switch off over all on, medians frame by frame; blank: 1 lies between the\n"
      "quartiles, or is the figure; %d threads, %s, %s\n%-21s",
      threads, machine().c_str(), vector_level().c_str(), "");
  for (const std::string& scene : scenes) std::printf("%8s", scene.c_str());
  for (const Switch& row : switches()) {
    std::printf("\n%-21s", row.name.c_str());
    for (const std::string& scene : scenes) {
      const auto found = results.at(scene).find(row.name);
      std::printf("%8s", found == results.at(scene).end() ? "" : cell(found->second).c_str());
    }
  }
  std::printf("\n");
}

nlohmann::json measure(bool quick) {
  const std::vector<std::string> few = {"S2", "S5B", "S9", "spots", "far"};
  const std::vector<std::string>& scenes = quick ? few : skip_scene_names();
  std::map<std::string, std::map<std::string, nlohmann::json>> results;
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& name : scenes) {
    SkipScene scene = make_skip_scene(name, threads);
    for (const Switch& to_turn : switches()) {
      if (to_turn.name == "reuse" && !scene.settings.reuse) continue;
      const nlohmann::json result =
          measure_switch(scene, to_turn, quick ? Effort{.1, 9, 9} : Effort{1.5, 15, 99});
      list.push_back(results[name][to_turn.name] = result);
    }
    std::printf("%s: %.2f ms\n", name.c_str(),
                results[name]["nothing"]["scanlit_ms"].get<double>());
    std::fflush(stdout);
  }
  print_table(scenes, results);
  return list;
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) {
  return scanlit::bench::bench_main(argc, argv, "What each switch of Skips saves",
                                    scanlit::bench::measure);
}
