// Which triangle does each pixel see: Scanlit's visibility stages beside Embree's rays through the
// same pixel centres (embree_peer.h), on two threads, in turn, of objects that stand still for
// Embree, whose tree is built beforehand; Scanlit knows nothing from one frame to the next.
//
// Scanlit draws without lights. The ratio compares work with work: of Scanlit the stages assembly
// (vertices, culling, sorting) and scan conversion, of Embree its tiles, each summed over threads.
// By the clock, Scanlit's whole frame counts against it: clearing the whole picture, and writing
// colour, depth and ids of every pixel.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench_main.h"
#include "embree_peer.h"
#include "report.h"
#include "scanlit_side.h"
#include "timing.h"
#include "visibility_difference.h"

namespace scanlit::bench {
namespace {

constexpr int threads = 2;

/// The unlit scene in frame 0.
class Visibility {
 public:
  explicit Visibility(const BenchScene& scene)
      : scene_(scanlit_scene(scene)), camera_(scanlit_camera(scene)) {
    scene_.lights.clear();
  }

  /// Returns the milliseconds of its visibility stages, summed over the threads.
  double draw() {
    const FrameStats stats = renderer_.render(scene_, camera_, {.threads = threads}, picture_);
    double seconds = 0;
    for (const Stage stage : {Stage::assembly, Stage::scan_conversion})
      seconds += stats.seconds[std::size_t(stage)];
    return 1e3 * seconds;
  }
  const Framebuffer& picture() const { return picture_; }

 private:
  Scene scene_;
  Camera camera_;
  Renderer renderer_;
  Framebuffer picture_{
      picture_width, picture_height, {.depth = true, .ids = true, .format = picture_planes.format}};
};

nlohmann::json compare_scene(const std::string& name, const Effort& effort, EmbreePeer& embree) {
  const BenchScene scene = make_bench_scene(name);
  Visibility scanlit(scene);
  Hits hits(picture_width, picture_height);
  scanlit.draw();
  embree.prepare(scene);
  const Rect rect = covered_rect(scanlit.picture());
  embree.trace(rect, hits);
  const VisibilityDifference difference = compare(scanlit.picture(), hits);

  Times frames, traces;
  std::vector<double> stages, tiles;
  repeat(effort, [&](int round) {
    for (int turn = 0; turn < 2; ++turn)
      if ((turn + round) % 2)
        frames.measure([&] { stages.push_back(scanlit.draw()); });
      else
        traces.measure([&] { tiles.push_back(embree.trace(rect, hits)); });
  });
  const FrameTime frame = frames.summary(), trace = traces.summary();
  return {{"scene", name},
          {"threads", threads},
          {"scanlit_ms", median(stages)},
          {"peer_ms", median(tiles)},
          {"ratio", median(tiles) / median(stages)},
          {"max_difference", difference.max_distance},
          {"mean_difference", difference.mean_distance},
          {"min_ratio", least(tiles) / least(stages)},
          {"scanlit_frame_ms", frame.median_ms},
          {"scanlit_frame_min_ms", frame.min_ms},
          {"peer_clock_ms", trace.median_ms},
          {"peer_clock_min_ms", trace.min_ms},
          {"clock_ratio", trace.median_ms / frame.median_ms},
          {"clock_min_ratio", trace.min_ms / frame.min_ms},
          {"rays", (rect.x_end - rect.x_begin) * (rect.y_end - rect.y_begin)},
          {"pixels_of_both", difference.both},
          {"another_triangle", difference.another_triangle},
          {"another_surface", difference.another_surface},
          {"coverage_differs", difference.coverage_differs},
          {"coverage_differs_inside", difference.coverage_differs_inside},
          {"peer", embree.version()},
          {"machine", machine()},
          {"vectors", vector_level()}};
}

void print_row(const nlohmann::json& r) {
  const auto f = [&](const char* key) { return r[key].get<double>(); };
  const auto n = [&](const char* key) { return r[key].get<long>(); };
  std::printf("%-5s %8ld %9.2f %9.2f %7.2f %7.2f %9.2f %9.2f %7.2f %7.2f %8ld %8ld %8ld %8ld\n",
              r["scene"].get<std::string>().c_str(), n("rays"), f("scanlit_ms"), f("peer_ms"),
              f("ratio"), f("min_ratio"), f("scanlit_frame_ms"), f("peer_clock_ms"),
              f("clock_ratio"), f("clock_min_ratio"), n("another_triangle"), n("another_surface"),
              n("coverage_differs"), n("coverage_differs_inside"));
  std::fflush(stdout);
}

nlohmann::json measure(bool quick) {
  EmbreePeer embree(threads);
  std::printf(
      "ms per frame, %dx%d, %d threads, on %s, Scanlit's vectors: %s; %s\n"
      "work: visibility stages, and rays, summed over the threads; clock: the whole unlit frame\n"
      "pixels: of both, those that show another triangle, and of these another surface; those "
      "that\n"
      "one covers alone, and of these not on the silhouette\n"
      "%-5s %8s %9s %9s %7s %7s %9s %9s %7s %7s %8s %8s %8s %8s\n",
      picture_width, picture_height, threads, machine().c_str(), vector_level().c_str(),
      embree.version().c_str(), "scene", "rays", "work", "Embree", "ratio", "least", "clock",
      "Embree", "ratio", "least", "triangle", "surface", "coverage", "inside");
  nlohmann::json results = nlohmann::json::array();
  for (const char* name : {"S2", "S4", "S7", "S5F", "S8P"}) {
    if (quick && name == std::string("S7")) continue;
    results.push_back(compare_scene(name, quick ? Effort{1, 5, 30} : Effort{8, 15, 200}, embree));
    print_row(results.back());
  }
  return results;
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) {
  return scanlit::bench::bench_main(argc, argv, "Scanlit's visibility beside Embree's",
                                    scanlit::bench::measure);
}
