// What RenderSettings::tolerance brings: the time of a frame in which all is evaluated over that of
// one in which pixels may be off by one code, frame by frame in turn, on one thread; and by how
// much they are off. The scenes of the comparison, which are linear, and frozen_scenes.h in sRGB.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bench_main.h"
#include "frozen_scenes.h"
#include "report.h"
#include "scanlit_side.h"
#include "timing.h"

namespace scanlit::bench {
namespace {

struct Subject {
  std::string name;
  Scene scene;
  Camera camera;
  RenderSettings settings;
  ColourFormat format;
};

std::vector<Subject> subjects(bool quick) {
  std::vector<Subject> all;
  for (const std::string name : {"S2", "S3", "S4", "S5F", "S6", "S8P", "S9"}) {
    if (quick && (name == "S4" || name == "S9")) continue;
    const BenchScene scene = make_bench_scene(name);
    all.push_back({name,
                   scanlit_scene(scene),
                   scanlit_camera(scene),
                   {.clamp_vertex_colours = true},
                   ColourFormat::linear_8bit});
  }
  for (FrozenScene& frozen : frozen_scenes())
    all.push_back(
        {frozen.name, std::move(frozen.scene), frozen.camera, {}, ColourFormat::srgb_8bit});
  return all;
}

/// In codes, of all channels.
struct Difference {
  int largest = 0;
  double mean = 0;
};
Difference difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  Difference result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int off = std::abs(int(a[i]) - int(b[i]));
    result.largest = std::max(result.largest, off);
    result.mean += off / double(a.size());
  }
  return result;
}

nlohmann::json measure(const Subject& subject, const Effort& effort) {
  struct Side {
    RenderSettings settings;
    Framebuffer picture;
    Renderer renderer{};
    FrameStats stats{};
    std::vector<double> ms{};
  };
  const Planes planes{.format = subject.format};
  Side sides[] = {{subject.settings, {picture_width, picture_height, planes}},
                  {subject.settings, {picture_width, picture_height, planes}}};
  for (Side& side : sides) side.settings.threads = 1;
  sides[1].settings.tolerance = 1;
  std::vector<double> ratios, shares;
  repeat(effort, [&](int round) {
    for (int turn = 0; turn < 2; ++turn) {
      Side& side = sides[(turn + round) % 2];
      side.stats = side.renderer.render(subject.scene, subject.camera, side.settings, side.picture);
      side.ms.push_back(1e3 * side.stats.wall_seconds);
    }
    const FrameStats& full = sides[0].stats;
    ratios.push_back(sides[0].ms.back() / sides[1].ms.back());
    shares.push_back(full.seconds[std::size_t(Stage::shading)] / full.wall_seconds);
  });
  const double share = median(shares);
  const Difference off = difference(sides[0].picture.rgba8, sides[1].picture.rgba8);
  const auto evaluations = [](const FrameStats& s) { return double(s.evaluations); };
  return {{"scene", subject.name},
          {"lights", subject.scene.lights.size()},
          {"ms", least(sides[0].ms)},
          {"tolerant_ms", least(sides[1].ms)},
          {"shading_share", share},
          {"ceiling", 1 / (1 - std::min(share, .999))},
          {"ratio", median(ratios)},
          {"evaluated", evaluations(sides[1].stats) / std::max(1.0, evaluations(sides[0].stats))},
          {"largest_difference", off.largest},
          {"mean_difference", off.mean}};
}

void print_mean(const nlohmann::json& results, bool mostly_shading) {
  double sum = 0;
  int count = 0;
  for (const auto& r : results) {
    if ((r["shading_share"].get<double>() > .5) != mostly_shading) continue;
    sum += std::log(r["ratio"].get<double>()), ++count;
  }
  if (count > 0)
    std::printf("geometric mean where shading is %s than half of the frame (%d): %.2f\n",
                mostly_shading ? "more" : "less", count, std::exp(sum / count));
}

nlohmann::json measure(bool quick) {
  nlohmann::json results = nlohmann::json::array();
  std::printf("one thread, %s, %s; tolerance 1 against 0\n", machine().c_str(),
              vector_level().c_str());
  std::printf("%-6s%7s%9s%9s%8s%9s%8s%11s%9s%9s\n", "scene", "lights", "ms", "ms", "share",
              "ceiling", "ratio", "evaluated", "largest", "mean");
  for (const Subject& subject : subjects(quick)) {
    const nlohmann::json r = measure(subject, quick ? Effort{.3, 7, 15} : Effort{3, 15, 99});
    std::printf("%-6s%7d%9.2f%9.2f%8.2f%9.2f%8.2f%11.2f%9d%9.4f\n",
                r["scene"].get<std::string>().c_str(), r["lights"].get<int>(),
                r["ms"].get<double>(), r["tolerant_ms"].get<double>(),
                r["shading_share"].get<double>(), r["ceiling"].get<double>(),
                r["ratio"].get<double>(), r["evaluated"].get<double>(),
                r["largest_difference"].get<int>(), r["mean_difference"].get<double>());
    std::fflush(stdout);
    results.push_back(r);
  }
  print_mean(results, true);
  print_mean(results, false);
  return results;
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) {
  return scanlit::bench::bench_main(argc, argv, "What tolerance 1 brings", scanlit::bench::measure);
}
