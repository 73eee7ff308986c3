// What a frame costs at least on this machine, beside what it takes, on one thread. Before each
// measurement other memory is read, so that no picture and no mesh is still in the cache, as after
// any other work between two frames.
//   pixels       every pixel of the picture is written once, at the rate of a memset of the picture
//   triangles    what is stored of vertices and triangles is read once, and each drawn triangle's
//                record written and read once, at the rate of reading memory
//   model        the reflection model at the points that were lit, everything it looks at prepared
//                and in the cache
//   arithmetic   the operations that transform, cull, set up and interpolate (counted below), at
//                the rate of independent multiply-adds
// No frame can beat the sum by much: the four overlap a little, and only the first is bound to be
// reached. It leaves out what scan conversion decides pixel by pixel, and everything that is not in
// vectors.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench_main.h"
#include "rasterizer/batch_vec.h"
#include "rasterizer/lighting.h"
#include "report.h"
#include "scanlit_side.h"
#include "timing.h"

namespace scanlit::bench {
namespace {

// Floating-point operations, a multiply-add being two.
constexpr double per_vertex = 4 * 6 + 1 + 3 * 2;  // four rows of the matrix, 1/w, the viewport
constexpr double per_triangle = 5;                // its area
constexpr double per_drawn = 3 * 7 + 2 * 7;       // three edges and the depth's two slopes
constexpr double per_fragment = 3 * 4 + 8;        // three edges' weights, divided by their sum
constexpr double per_channel = 4;                 // an attribute's, at a fragment

// Bytes.
constexpr double vertex_bytes = 12, triangle_bytes = 3;  // positions; indices inside of a cluster
constexpr double drawn_bytes = 2 * sizeof(DrawnTriangle);
constexpr double shaded_triangle_bytes = 3 * (4 + 12 + 12);  // its corners' indices and attributes

struct Machine {
  double picture_ms;         // a memset of the picture
  double read_bytes_per_ms;  // from memory
  double operations_per_ms;  // in vectors
};

/// Work's least time of several, in milliseconds; before() is not measured.
template <class Before, class Work>
double least_ms(const Before& before, const Work& work) {
  std::vector<double> times;
  repeat({.seconds = 1, .min_rounds = 5, .max_rounds = 100}, [&](int) {
    before();
    const auto start = Clock::now();
    work();
    times.push_back(ms_since(start));
  });
  return least(times);
}

/// More memory than any cache holds.
class OtherMemory {
 public:
  std::size_t bytes() const { return floats_.size() * sizeof(float); }
  void read() const {
    Batch sums[4] = {Batch(0), Batch(0), Batch(0), Batch(0)};
    for (std::size_t i = 0; i < floats_.size(); i += 4 * Batch::lanes)
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) sums[k] += Batch::load(&floats_[i] + k * Batch::lanes);
    benchmark::DoNotOptimize(sums);
  }

 private:
  std::vector<float> floats_ = std::vector<float>(std::size_t(64) << 20, 1.0f);
};

double operations_per_ms() {
  constexpr int rounds = 100000, chains = 12;  // enough to hide an operation's latency
  Batch values[chains];
  const auto compute = [&] {
#pragma GCC unroll 12
    for (int k = 0; k < chains; ++k) values[k] = Batch(float(k));
    for (int i = 0; i < rounds; ++i)
#pragma GCC unroll 12
      for (int k = 0; k < chains; ++k) values[k] = mul_add(values[k], Batch(.5f), Batch(1));
    benchmark::DoNotOptimize(values);
  };
  return 2.0 * rounds * chains * Batch::lanes / least_ms([] {}, compute);
}

Machine measure_machine(const OtherMemory& memory) {
  std::vector<std::uint8_t> picture(std::size_t(4) * picture_width * picture_height);
  const auto clear = [&] {
    std::memset(picture.data(), 0, picture.size());
    benchmark::ClobberMemory();
  };
  return {.picture_ms = least_ms([&] { memory.read(); }, clear),
          .read_bytes_per_ms = double(memory.bytes()) / least_ms([] {}, [&] { memory.read(); }),
          .operations_per_ms = operations_per_ms()};
}

/// Nanoseconds that a scene's model takes for one point under all lights, in the cache.
double model_ns(const BenchScene& bench) {
  const Scene scene = scanlit_scene(bench);
  const Camera camera = scanlit_camera(bench);
  const RenderSettings settings;
  const Frame frame{scene, camera, settings, {}, {}, {}, {}};
  Draw draw{};
  draw.object = &scene.objects[0];
  draw.illumination = illuminate(frame, draw);

  constexpr int padded = SurfaceSpan::padded;
  auto points = std::make_unique<float[][3][padded]>(3);
  for (int i = 0; i < padded; ++i) {  // of the unit sphere's lit side
    const double x = .9 * i / padded, y = .3, z = std::sqrt(1 - x * x - y * y);
    const double point[3] = {x, y, z};
    const double away = std::hypot(x, y, z - camera.eye.z);
    for (int c = 0; c < 3; ++c) {
      points[0][c][i] = points[1][c][i] = float(point[c]);
      points[2][c][i] = float((camera.eye[c] - point[c]) / away);
    }
  }
  LitSpan lit;
  ViewedSpan in{.size = SurfaceSpan::capacity};
  RadianceSpan out{.ambient = draw.illumination.ambient};
  for (int c = 0; c < 3; ++c) {
    in.normal[c] = points[0][c], in.position[c] = points[1][c], in.to_viewer[c] = points[2][c];
    out.colour[c] = lit.colour[c];
  }
  const ReflectionModel& model = *draw.object->material.model;
  constexpr int spans = 200;
  const double ms = least_ms([] {},
                             [&] {
                               for (int i = 0; i < spans; ++i)
                                 model.radiance(in, draw.illumination.lights, out);
                             });
  return 1e6 * ms / (spans * double(SurfaceSpan::capacity));
}

struct Floor {
  double pixels, triangles, model, arithmetic;
  double sum() const { return pixels + triangles + model + arithmetic; }
};

Floor floor_of(const BenchScene& bench, const FrameStats& stats, const Machine& machine) {
  const bool gouraud = bench.shader == Shader::gouraud;
  const double lights = bench.shader == Shader::point_lights ? 16 : 1;
  // Interpolated: three channels of a colour, or normal and position.
  const double channels = gouraud ? 3 : 6;
  const double fragments = double(stats.fragments), drawn = double(stats.drawn);
  const double looked_at = double(stats.triangles - stats.outside - stats.back_facing);
  const double lit = double(stats.evaluations) / lights;
  const double shaded_triangles = std::min(drawn, fragments);
  const double bytes = vertex_bytes * double(stats.vertices) + triangle_bytes * looked_at +
                       drawn_bytes * drawn + shaded_triangle_bytes * shaded_triangles;
  const double operations = per_vertex * double(stats.vertices) + per_triangle * looked_at +
                            per_drawn * drawn + (per_fragment + channels * per_channel) * fragments;
  return {.pixels = machine.picture_ms,
          .triangles = bytes / machine.read_bytes_per_ms,
          .model = 1e-6 * lit * model_ns(bench),
          .arithmetic = operations / machine.operations_per_ms};
}

nlohmann::json measure(bool quick) {
  const OtherMemory memory;
  const Machine machine = measure_machine(memory);
  std::printf(
      "one thread of %s, %s: the picture's memset %.2f ms, reading %.1f GB/s, %.0f GFLOP/s\n",
      bench::machine().c_str(), vector_level().c_str(), machine.picture_ms,
      1e-6 * machine.read_bytes_per_ms, 1e-6 * machine.operations_per_ms);
  std::printf("ms per frame, least of several\n%-5s %8s %10s %8s %11s %8s %9s %9s\n", "scene",
              "pixels", "triangles", "model", "arithmetic", "floor", "measured", "measured");
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& name : scene_names()) {
    const BenchScene bench = make_bench_scene(name);
    if (bench.reuse || name == "S0" || (quick && name == "S7")) continue;
    ScanlitSide side(1);
    side.prepare(bench);
    int frame = 0;
    side.draw(bench, frame++);
    const double measured = least_ms([&] { memory.read(); }, [&] { side.draw(bench, frame++); });
    const Floor floor = floor_of(bench, side.stats(), machine);
    std::printf("%-5s %8.2f %10.2f %8.2f %11.2f %8.2f %9.2f %6.1f times\n", name.c_str(),
                floor.pixels, floor.triangles, floor.model, floor.arithmetic, floor.sum(), measured,
                measured / floor.sum());
    std::fflush(stdout);
    list.push_back({{"scene", name},
                    {"pixels_ms", floor.pixels},
                    {"triangles_ms", floor.triangles},
                    {"model_ms", floor.model},
                    {"arithmetic_ms", floor.arithmetic},
                    {"scanlit_ms", measured}});
  }
  return list;
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) {
  return scanlit::bench::bench_main(argc, argv, "What a frame costs at least",
                                    scanlit::bench::measure);
}
