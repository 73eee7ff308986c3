// The picture does not depend on the number of threads: every plane, to the bit.
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <random>
#include <thread>

#include "models/blinn_phong.h"
#include "rasterizer/error.h"
#include "rasterizer/parallel.h"
#include "tests/unit/same_picture.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

void expect_same(const Picture& a, const Picture& b) {
  EXPECT_EQ(planes_that_differ(a.framebuffer, b.framebuffer), "");
  EXPECT_EQ(a.stats.drawn, b.stats.drawn);
  EXPECT_EQ(a.stats.fragments, b.stats.fragments);
  EXPECT_EQ(a.stats.covered_pixels, b.stats.covered_pixels);
  EXPECT_EQ(a.stats.evaluations, b.stats.evaluations);
  EXPECT_EQ(a.stats.spans, b.stats.spans);
}

/// Triangles of all sizes in all directions, some through the near plane and behind the eye; many
/// share vertices, many lie at equal depths.
std::shared_ptr<Mesh> tangle(unsigned seed, int vertices, int triangles) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> unit(-1, 1);
  auto mesh = std::make_shared<Mesh>();
  for (int i = 0; i < vertices; ++i) {
    mesh->positions.emplace_back(2 * unit(random), 2 * unit(random), 2 * unit(random) - 1.7f);
    mesh->normals.push_back(glm::normalize(glm::vec3(unit(random), unit(random), 1)));
  }
  std::uniform_int_distribution<std::uint32_t> any(0, std::uint32_t(vertices) - 1);
  for (int i = 0; i < triangles; ++i) {
    // Most are small: their corners are neighbours in a sense, and close by.
    const std::uint32_t a = any(random);
    for (const std::uint32_t corner : {a, any(random), any(random)})
      mesh->indices.push_back(corner);
    if (i % 4) {
      for (int k = 1; k < 3; ++k) {
        mesh->indices[mesh->indices.size() - std::size_t(k)] =
            std::uint32_t(mesh->positions.size());
        mesh->positions.push_back(mesh->positions[a] +
                                  0.03f * glm::vec3(unit(random), unit(random), 0));
        mesh->normals.push_back(mesh->normals[a]);
      }
    }
  }
  return mesh;
}

Scene busy_scene() {
  std::vector<Object> objects;
  unsigned seed = 1;
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong})
    for (const Sides sides : {Sides::front, Sides::both}) {
      // More than one chunk of clusters in some, none at all in others.
      Object object = object_of(tangle(seed, 300, seed == 3 ? 18000 : 1000), White(), shading);
      object.material.model =
          std::make_shared<FormulaModel<models::BlinnPhong<>>>(models::BlinnPhong<>());
      object.material.ka = Rgb<double>(0.2);
      object.material.form = seed % 2 ? ColourForm::tinted : ColourForm::plastic;
      object.sides = sides;
      objects.push_back(object);
      objects.push_back(object_of(std::make_shared<Mesh>()));
      ++seed;
    }
  objects.push_back(objects[0]);  // at the same depths
  Scene scene = scene_of(objects);
  scene.ambient = Rgb<double>(0.5);
  scene.background = {0.1, 0.2, 0.3};
  Light& point = scene.lights.emplace_back();
  point.kind = LightKind::point;
  point.position = {1, 1, 1};
  return scene;
}

class Threads : public testing::TestWithParam<int> {};

TEST_P(Threads, AnyNumberGivesTheSameBits) {
  const Scene scene = busy_scene();
  RenderSettings settings = with_samples(GetParam());
  settings.threads = 1;
  const Picture one = picture_of(scene, eye_at_origin(), 200, 150, settings);
  EXPECT_GT(one.stats.clipped, 100);
  EXPECT_GT(one.stats.back_facing, 100);
  EXPECT_GT(one.stats.covered_pixels, 20000);
  for (const int threads : {1, 2, 3, 8, 0}) {
    SCOPED_TRACE(threads);
    settings.threads = threads;
    expect_same(one, picture_of(scene, eye_at_origin(), 200, 150, settings));
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Threads, testing::Values(1, 4, 8, 16));

TEST(ThreadSettings, ProgressRisesToOne) {
  RenderSettings settings;
  settings.threads = 3;
  double last = 0;
  settings.progress = [&](double done) {
    EXPECT_GT(done, last);
    last = done;
  };
  picture_of(scene_of({}), eye_at_origin(), 200, 300, settings);
  EXPECT_EQ(last, 1.0);
}

TEST(ThreadSettings, ProgressThatThrowsStopsAllThreads) {
  for (const int threads : {1, 4}) {
    int calls = 0;
    RenderSettings settings{.threads = threads};
    settings.progress = [&](double) {
      if (++calls == 5) throw std::runtime_error("enough");
    };
    EXPECT_THROW(picture_of(scene_of({}), eye_at_origin(), 200, 30000, settings),
                 std::runtime_error);
    EXPECT_LT(calls, 100) << "tiles of 469";
  }
}

// As above, with a second thread that is certainly at work when the first one fails.
TEST(ThreadSettings, WorkThatThrowsStopsTheOtherThreads) {
  using namespace std::chrono_literals;
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  constexpr std::size_t count = 200;
  std::atomic<bool> failed{false};
  std::atomic<std::size_t> begun{0};
  const auto work = [&](std::size_t i) {
    ++begun;
    if (i == 0) {
      while (begun < 2) std::this_thread::sleep_for(1ms);
      failed = true;
      throw std::runtime_error("enough");
    }
    while (!failed) std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(i == 1 ? 50ms : 1ms);  // the first thread has said so by then
  };
  EXPECT_THROW(tbb::task_arena(2).execute([&] { parallel(count, work); }), std::runtime_error);
  EXPECT_LT(begun, count / 2);
}

TEST(ThreadSettings, SettingsOutOfRangeAreRefused) {
  Framebuffer framebuffer(4, 4);
  for (const int threads : {-1, 1025}) {
    RenderSettings settings;
    settings.threads = threads;
    EXPECT_THROW(render(scene_of({}), Camera(), settings, framebuffer), Error);
  }
  for (const int samples : {-1, 0, 2, 3, 5, 32})
    EXPECT_THROW(render(scene_of({}), Camera(), with_samples(samples), framebuffer), Error);
}

}  // namespace
}  // namespace scanlit
