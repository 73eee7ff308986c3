// Shading a fragment in vector arithmetic and in scalar float: the same formula, the same inputs,
// the same outputs, measured in one run.
//   evaluate   the model alone: unit directions in, diffuse and glossy part out; for Batch one
//              virtual call per span of 256 fragments
//   light      what the renderer does with a span: position and normal to world space, normal and
//              direction to the viewer normalised, the model under one directional light, times
//              the light's colour; for the lecture's models, which need no tangents
// Both flush subnormals, as render() does.
#include <benchmark/benchmark.h>
#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>

#include "models/registry.h"
#include "report.h"
#include "scalar_path.h"

namespace scanlit::bench {
namespace {

constexpr int span_count = 8;  // more than one, so that branches cannot be learnt by heart
constexpr int points = span_count * SurfaceSpan::capacity;

/// Spans of random points of the unit sphere's visible side, seen and lit as in a frame.
struct Setup {
  Scene scene;
  Camera camera{.eye = {0, 0, 4.15}};
  RenderSettings settings;
  Frame frame{scene, camera, settings, {}, {}, {}, {}};
  Draw draw{};
  SurfaceSpan surface[span_count];
  LitSpan lit;
  float to_light[3][SurfaceSpan::padded], to_viewer[span_count][3][SurfaceSpan::padded];
  float tangent[span_count][3][SurfaceSpan::padded];

  explicit Setup(const std::string& model) {
    scene.lights.push_back({.direction = {1, 1, 1}});
    scene.objects.resize(1);
    scene.objects[0].material.model = models::make(model).model;
    draw.object = &scene.objects[0];
    draw.normal_from_object = glm::mat3(1);
    draw.illumination = illuminate(frame, draw);
    for (int c = 0; c < 3; ++c) std::fill_n(to_light[c], SurfaceSpan::padded, std::sqrt(1 / 3.0f));
    std::mt19937 random(1);
    for (int s = 0; s < span_count; ++s) fill(s, random);
  }
  Setup(const Setup&) = delete;

  void fill(int s, std::mt19937& random) {
    surface[s].size = SurfaceSpan::capacity;
    std::uniform_real_distribution<double> azimuth(0, 2 * M_PI);
    std::uniform_real_distribution<double> height(1 / camera.eye.z, 1);
    for (int i = 0; i < SurfaceSpan::capacity; ++i) {
      const double z = height(random), r = std::sqrt(1 - z * z), phi = azimuth(random);
      const double point[3] = {r * std::cos(phi), r * std::sin(phi), z};
      const double around[3] = {-std::sin(phi), std::cos(phi), 0};
      const double distance = std::hypot(point[0], point[1], point[2] - camera.eye.z);
      for (int c = 0; c < 3; ++c) {
        surface[s].position[c][i] = surface[s].normal[c][i] = float(point[c]);
        tangent[s][c][i] = float(around[c]);
        to_viewer[s][c][i] = float((camera.eye[c] - point[c]) / distance);
      }
    }
  }

  DirectionSpan directions(int s) const {
    DirectionSpan in{.size = SurfaceSpan::capacity};
    for (int c = 0; c < 3; ++c) {
      in.normal[c] = surface[s].normal[c];
      in.to_light[c] = to_light[c];
      in.to_viewer[c] = to_viewer[s][c];
      if (scene.objects[0].material.model->needs().frame) in.tangent[c] = tangent[s][c];
    }
    return in;
  }
  ReflectionSpan reflection() {
    ReflectionSpan out;
    for (int c = 0; c < 3; ++c) out.diffuse[c] = lit.diffuse[c], out.glossy[c] = lit.glossy[c];
    return out;
  }
};

/// The largest difference between what two ways of shading make of the same spans.
template <class One, class Other>
float difference(Setup& setup, One one, Other other) {
  float largest = 0;
  for (int s = 0; s < span_count; ++s) {
    one(setup, s);
    const auto first = std::make_unique<LitSpan>(setup.lit);
    other(setup, s);
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < SurfaceSpan::capacity; ++i)
        largest = std::max({largest, std::abs(first->diffuse[c][i] - setup.lit.diffuse[c][i]),
                            std::abs(first->glossy[c][i] - setup.lit.glossy[c][i])});
  }
  return largest;
}

template <class ShadeSpan>
void measure(const std::string& name, const std::shared_ptr<Setup>& setup, ShadeSpan shade_span) {
  benchmark::RegisterBenchmark(name.c_str(), [setup, shade_span](benchmark::State& state) {
    for (auto _ : state) {
      for (int s = 0; s < span_count; ++s) shade_span(*setup, s);
      benchmark::ClobberMemory();
    }
    state.counters["ns"] = benchmark::Counter(
        points * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  });
}

/// Measures two ways of shading, having seen that they give the same.
template <class Scalar, class Vector>
void compare(const std::string& name, const std::shared_ptr<Setup>& setup, Scalar scalar,
             Vector vector) {
  if (const float d = difference(*setup, scalar, vector); !(d < 1e-5f)) {
    std::fprintf(stderr, "error: %s: scalar and Batch differ by %g\n", name.c_str(), double(d));
    std::exit(1);
  }
  measure(name + " scalar", setup, scalar);
  measure(name + " batch", setup, vector);
}

/// Every model that is one formula, where it has choices the ones that differ in cost.
const std::vector<std::string> specifications = {
    "lambert",
    "phong",
    "blinn-phong",
    "blinn-phong:normalised=1",
    "torrance-sparrow",
    "cook-torrance",
    "cook-torrance:F=conductor",
    "cook-torrance:D=gaussian",
    "cook-torrance:D=ggx,G=smith",
    "cook-torrance:D=ggx,G=smith-correlated,F=schlick",
    "cook-torrance:D=beckmann,G=smith",
    "cook-torrance:D=ashikhmin-shirley",
    "cook-torrance:D=anisotropic-beckmann",
    "cook-torrance:D=anisotropic-ggx,G=smith",
    "ward",
    "oren-nayar",
    "oren-nayar-full",
    "ashikhmin-shirley",
    "finished-wood",
};
/// And of those that are no single formula, without a scalar twin.
const std::vector<std::string> compositions = {
    "lafortune:lobe=(cx=-1,cz=1,n=20)",
    "lafortune:lobe=(cx=-1,cz=1,n=20),lobe=(cx=.8,cz=.6,n=8),lobe=(cx=1,cz=1,n=4)",
    "sum:(lambert),(ward)",
    "clear-coat:base=(lambert)",
    "clear-coat:base=(lambert),a=.15",
};
const std::vector<std::string> lit_specifications = {"blinn-phong", "phong", "lambert"};

void evaluate_batch(Setup& on, int s) {
  on.scene.objects[0].material.model->evaluate(on.directions(s), on.reflection());
}

void compare_evaluate(const std::string& specification) {
  const auto setup = std::make_shared<Setup>(specification);
  compare(
      "evaluate " + specification, setup,
      [path = scalar_path(specification)](Setup& on, int s) {
        path.evaluate(on.directions(s), on.reflection());
      },
      evaluate_batch);
}

void compare_light(const std::string& specification) {
  const auto setup = std::make_shared<Setup>(specification);
  compare(
      "light " + specification, setup,
      [path = scalar_path(specification)](Setup& on, int s) {
        path.light(on.frame, on.draw, on.surface[s], on.lit);
      },
      [](Setup& on, int s) {
        FrameStats stats;
        light(on.frame, on.draw, on.surface[s], on.lit, stats);
      });
}

void print_row(const Figures& figures, const std::string& name) {
  const auto scalar = figures.find(name + " scalar"), batch = figures.find(name + " batch");
  if (batch == figures.end()) return;
  const double b = batch->second.at("ns");
  if (scalar == figures.end()) {
    std::printf("%-88s %8s %8.2f\n", name.c_str(), "", b);
    return;
  }
  const double a = scalar->second.at("ns");
  std::printf("%-88s %8.2f %8.2f %8.1f\n", name.c_str(), a, b, a / b);
}

void print_table(const Figures& figures) {
  std::printf("%-88s %8s %8s %8s\n", ("ns per fragment, " + vector_level()).c_str(), "scalar",
              "Batch", "ratio");
  for (const std::string& s : specifications) print_row(figures, "evaluate " + s);
  for (const std::string& s : compositions) print_row(figures, "evaluate " + s);
  for (const std::string& s : lit_specifications) print_row(figures, "light " + s);
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) {
  using namespace scanlit::bench;
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  for (const std::string& s : specifications) compare_evaluate(s);
  for (const std::string& s : compositions)
    measure("evaluate " + s + " batch", std::make_shared<Setup>(s), evaluate_batch);
  for (const std::string& s : lit_specifications) compare_light(s);
  print_table(run(argc, argv));
}
