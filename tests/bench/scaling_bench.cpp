// How a frame's time grows with triangles (spheres, Phong), pixels (S2 in squares), lights (S6 with
// more and fewer) and threads; and how much memory ten million triangles take while they are drawn.
// Between neighbours the exponent p says that the time grows as the size to the power p: at most 1
// is wanted, of threads -1.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench_main.h"
#include "bench_shapes.h"
#include "child_process.h"
#include "report.h"
#include "scanlit_side.h"
#include "timing.h"

namespace scanlit::bench {
namespace {

/// One size of a series.
struct Step {
  double size;
  BenchScene bench;
  int width = picture_width, height = picture_height, threads = 2, light_count = 16;
};

/// Ready to draw it.
class Drawn {
 public:
  explicit Drawn(const Step& step)
      : bench_(step.bench),
        scene_(scanlit_scene(bench_)),
        camera_(scanlit_camera(bench_)),
        settings_{.threads = step.threads, .clamp_vertex_colours = true},
        picture_(step.width, step.height, picture_planes) {
    if (bench_.shader == Shader::point_lights) scene_.lights = scanlit_lights(step.light_count);
  }

  void draw(int frame) {
    pose(bench_, frame, scene_, camera_);
    times_.measure([&] { renderer_.render(scene_, camera_, settings_, picture_); });
  }
  void forget_times() { times_ = {}; }
  FrameTime time() const { return times_.summary(); }

 private:
  BenchScene bench_;
  Scene scene_;
  Camera camera_;
  RenderSettings settings_;
  Framebuffer picture_;
  Renderer renderer_;
  Times times_;
};

/// Prints the series and returns a list of its steps. The sizes are drawn in turn, so that a busy
/// moment does not hit one of them alone.
nlohmann::json measure_series(const std::string& name, const std::vector<Step>& steps,
                              const Effort& effort) {
  std::vector<std::unique_ptr<Drawn>> drawn;
  for (const Step& step : steps) {
    drawn.push_back(std::make_unique<Drawn>(step));
    drawn.back()->draw(0);  // warm
    drawn.back()->forget_times();
  }
  repeat(effort, [&](int round) {
    for (const auto& one : drawn) one->draw(1 + round);
  });

  std::printf("\n%-12s %10s %10s %9s\n", name.c_str(), "median ms", "least ms", "exponent");
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const FrameTime time = drawn[i]->time();
    std::printf("%12.0f %10.2f %10.2f", steps[i].size, time.median_ms, time.min_ms);
    list.push_back({{"series", name},
                    {"size", steps[i].size},
                    {"threads", steps[i].threads},
                    {"scanlit_ms", time.median_ms},
                    {"min_ms", time.min_ms}});
    if (i > 0) {
      const double exponent = std::log(time.min_ms / drawn[i - 1]->time().min_ms) /
                              std::log(steps[i].size / steps[i - 1].size);
      std::printf(" %9.2f", exponent);
      list.back()["exponent"] = exponent;
    }
    std::printf("\n");
  }
  std::fflush(stdout);
  return list;
}

std::vector<Step> triangle_steps(bool quick) {
  std::vector<Step> steps;
  for (const auto& [stacks, slices] :
       {std::pair{26, 20}, {51, 100}, {101, 500}, {501, 1000}, {2001, 2500}}) {
    if (quick && stacks > 1000) continue;
    const auto mesh = std::make_shared<Mesh>(sphere(stacks, slices));
    steps.push_back({.size = double(mesh->triangle_count()),
                     .bench = {.name = "sphere", .placements = {{.mesh = mesh}}}});
  }
  return steps;
}

std::vector<Step> pixel_steps(bool quick) {
  std::vector<Step> steps;
  for (int side = 256; side <= (quick ? 2048 : 8192); side *= 2)
    steps.push_back({.size = double(side) * side,
                     .bench = make_bench_scene("S2"),
                     .width = side,
                     .height = side});
  return steps;
}

std::vector<Step> light_steps() {
  std::vector<Step> steps;
  for (int count = 1; count <= 64; count *= 2)
    steps.push_back({.size = double(count), .bench = make_bench_scene("S6"), .light_count = count});
  return steps;
}

std::vector<Step> thread_steps(const std::string& scene) {
  std::vector<Step> steps;
  for (const int threads : {1, 2})
    steps.push_back(
        {.size = double(threads), .bench = make_bench_scene(scene), .threads = threads});
  return steps;
}

nlohmann::json measure_memory() {
  const auto program = std::filesystem::path(this_program()).parent_path() / "peak_memory";
  double mesh_bytes = 0, peak_bytes = 0;
  run_process({program.string()}, {}, [&](const std::string& line) {
    std::istringstream(line) >> mesh_bytes >> peak_bytes;
  });
  std::printf(
      "\nten million triangles: mesh %.0f MB, process at most %.0f MB, %.2f times as much\n",
      mesh_bytes / 1e6, peak_bytes / 1e6, peak_bytes / mesh_bytes);
  return {{"series", "memory"},
          {"mesh_bytes", mesh_bytes},
          {"peak_bytes", peak_bytes},
          {"ratio", peak_bytes / mesh_bytes}};
}

nlohmann::json measure(bool quick) {
  const Effort effort = quick ? Effort{1, 5, 30} : Effort{15, 15, 200};
  std::printf("ms per frame, two threads but where threads vary, %s, %s\n", machine().c_str(),
              vector_level().c_str());
  nlohmann::json all = nlohmann::json::array();
  const auto add = [&](const std::string& name, const std::vector<Step>& steps) {
    for (const nlohmann::json& step : measure_series(name, steps, effort)) all.push_back(step);
  };
  add("triangles", triangle_steps(quick));
  add("pixels", pixel_steps(quick));
  add("lights", light_steps());
  for (const char* scene : {"S2", "S3", "S4", "S5F", "S5B", "S5M", "S6"})
    add(std::string("threads, ") + scene, thread_steps(scene));
  if (!quick) all.push_back(measure_memory());
  return all;
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) {
  return scanlit::bench::bench_main(argc, argv, "How a frame's time and memory grow",
                                    scanlit::bench::measure);
}
