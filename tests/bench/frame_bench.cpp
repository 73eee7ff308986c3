// A whole frame, stage by stage: spheres of 2,000 and of a million triangles at 1920x1080, shaded
// per fragment by Blinn-Phong under one directional light, on one thread and on all.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>

#include "bench_scenes.h"
#include "models/registry.h"
#include "rasterizer/framebuffer.h"
#include "rasterizer/render.h"
#include "report.h"

namespace scanlit::bench {
namespace {

void measure(const std::string& name, const std::shared_ptr<const Mesh>& mesh, int threads) {
  Scene scene;
  scene.ambient = Rgb<double>(1.0);
  scene.lights = {{.direction = {1, 1, 1}}};
  Object& object = scene.objects.emplace_back();
  object.mesh = mesh;
  object.material = {.model = models::make("blinn-phong:kd=.7/.3/.2,ks=.3,n=32").model,
                     .ka = {0.035, 0.015, 0.01}};
  const Camera camera{.eye = {0, 0, 4.15}, .near = 1, .far = 100};
  const RenderSettings settings{.threads = threads};
  benchmark::RegisterBenchmark(
      name.c_str(),
      [=](benchmark::State& state) {
        Framebuffer picture(1920, 1080);
        FrameStats stats;
        for (auto _ : state) {
          stats = render(scene, camera, settings, picture);
          for (int s = 0; s < int(Stage::count); ++s)
            state.counters[scanlit::name(Stage(s))] += 1e3 * stats.seconds[std::size_t(s)];
          state.counters["by the clock"] += 1e3 * stats.wall_seconds;
        }
        for (auto& [key, counter] : state.counters)
          counter.flags = benchmark::Counter::kAvgIterations;
        state.counters["triangles drawn"] = double(stats.drawn);
        state.counters["fragments"] = double(stats.fragments);
        state.counters["mean span"] = double(stats.evaluations) / double(stats.spans);
      })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void print_table(const Figures& figures) {
  const char* const columns[] = {"2000 1", "2000 all", "1000000 1", "1000000 all"};
  const auto row = [&](const char* counter, int decimals) {
    std::printf("%-24s", counter);
    for (const char* column : columns) {
      const auto found = figures.find(column);
      if (found != figures.end()) std::printf("%14.*f", decimals, found->second.at(counter));
    }
    std::printf("\n");
  };
  std::printf("ms per frame (%s)\n%-24s%14s%14s%14s%14s\n", vector_level().c_str(), "triangles",
              "2,000", "2,000", "1,000,000", "1,000,000");
  std::printf("%-24s%14s%14s%14s%14s\n", "threads", "1", "all", "1", "all");
  for (int s = 0; s < int(Stage::count); ++s) row(name(Stage(s)), 2);
  row("by the clock", 2);
  std::printf("stages are summed over the threads\n");
  for (const char* count : {"triangles drawn", "fragments", "mean span"}) row(count, 0);
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) {
  using namespace scanlit::bench;
  for (const auto& [name, scene] : {std::pair{"2000", "S2"}, std::pair{"1000000", "S4"}}) {
    const auto mesh = make_bench_scene(scene).placements[0].mesh;
    measure(std::string(name) + " 1", mesh, 1);
    measure(std::string(name) + " all", mesh, 0);
  }
  print_table(run(argc, argv));
}
