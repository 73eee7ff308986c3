// The comparison with another renderer: its scenes are what their definitions say, and pictures
// that differ are found out.
#include "tests/bench/bench_scenes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "tests/bench/bench_room.h"
#include "tests/bench/picture_difference.h"

namespace scanlit::bench {
namespace {

TEST(BenchScenes, HaveTheirTriangles) {
  const std::map<std::string, std::size_t> drawn = {
      {"S0", 0},         {"S1", 2000},     {"S2", 2000},     {"S3", 2000},
      {"S4", 1'000'000}, {"S5F", 128'000}, {"S5B", 128'000}, {"S5M", 128'000},
      {"S6", 2000},      {"S8G", 100'000}, {"S8P", 100'000}};
  for (const auto& [name, triangles] : drawn) {
    std::size_t sum = 0;
    for (const Placement& placement : make_bench_scene(name).placements)
      sum += placement.mesh->triangle_count();
    EXPECT_EQ(sum, triangles) << name;
  }
}

TEST(BenchScenes, FrontFacesLookOutwards) {
  for (const char* name : {"S2", "S8P", "S9"}) {  // S9's first draw is a box
    const auto mesh = make_bench_scene(name).placements[0].mesh;
    for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return mesh->positions[mesh->indices[i + k]]; };
      const glm::vec3 face = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
      ASSERT_GT(glm::dot(face, mesh->normals[mesh->indices[i]]), 0)
          << name << ", triangle " << i / 3;
    }
  }
}

TEST(BenchScenes, NestedSpheresHideEachOther) {
  const BenchScene back_to_front = make_bench_scene("S5B"), front_to_back = make_bench_scene("S5F");
  for (std::size_t i = 0; i < 64; ++i) {
    const Placement& sphere = front_to_back.placements[i];
    EXPECT_EQ(sphere.scale, back_to_front.placements[63 - i].scale);
    // The angle of the silhouette seen from the eye, as a share of half the field of view.
    const double sine = sphere.scale.x / glm::length(sphere.centre);
    const double height = sine / std::sqrt(1 - sine * sine) / std::tan(glm::radians(fov_deg / 2));
    EXPECT_NEAR(height, .95, .001);
  }
}

TEST(BenchScenes, TurnAHundredthRadianAFrame) {
  for (const char* name : {"S2", "S5B", "S5M"}) {
    const BenchScene scene = make_bench_scene(name);
    const Placement& placement = scene.placements[0];
    for (int frame = 0; frame < 50; ++frame) {
      const glm::vec4 x(1, 0, 0, 0);
      const auto a = world_from_object(scene, placement, frame) * x;
      const auto b = world_from_object(scene, placement, frame + 1) * x;
      EXPECT_NEAR(glm::distance(a, b) / placement.scale.x, .01, 1e-5) << name << " " << frame;
    }
  }
}

TEST(BenchScenes, TeapotsStandFreely) {
  const BenchScene scene = make_bench_scene("S9");
  const std::size_t boxes = scene.placements.size() - teapot_count;
  ASSERT_EQ(boxes, 2 + 4 + 8 + 64);
  for (std::size_t i = boxes; i < scene.placements.size(); ++i) {
    const Placement& teapot = scene.placements[i];
    const auto apart = [&](const Placement& other, const glm::dvec3& half_size) {
      const glm::dvec3 offset = glm::abs(teapot.centre - other.centre) - half_size;
      return glm::length(glm::max(glm::dvec2(offset.x, offset.z), glm::dvec2(0)));
    };
    for (std::size_t k = 2; k < boxes; ++k)  // after floor and ceiling
      ASSERT_GT(apart(scene.placements[k], scene.placements[k].scale / 2.0), teapot.scale.x);
    for (std::size_t k = boxes; k < i; ++k)
      ASSERT_GT(apart(scene.placements[k], glm::dvec3(0)),
                teapot.scale.x + scene.placements[k].scale.x);
  }
}

/// What is not at its place of frame 0 in frame 7.
struct Moved {
  std::size_t draws = 0;
  bool camera = false, light = false;
};
Moved moved(const BenchScene& scene) {
  Moved result;
  for (const Placement& placement : scene.placements)
    result.draws +=
        world_from_object(scene, placement, 7) != world_from_object(scene, placement, 0);
  result.camera = viewing_direction(scene, 7) != viewing_direction(scene, 0);
  result.light = to_light(scene, 7) != to_light(scene, 0);
  return result;
}

TEST(BenchScenes, OfTheRoomMovesWhatIsSaid) {
  const auto expect = [](const char* name, std::size_t draws, bool camera, bool light) {
    const Moved m = moved(make_bench_scene(name));
    EXPECT_EQ(m.draws, draws) << name;
    EXPECT_EQ(m.camera, camera) << name;
    EXPECT_EQ(m.light, light) << name;
  };
  expect("S9", teapot_count, true, false);
  expect("S10L", 0, false, true);
  expect("S10M", 1, false, false);
  expect("S10N", 0, false, false);
}

Picture grey(int count, std::uint8_t value) {
  Picture picture;
  for (int i = 0; i < count; ++i) picture.insert(picture.end(), {value, value, value, 255});
  return picture;
}

TEST(PictureDifference, RoundingIsNoDifference) {
  Picture a = grey(20000, 100), b = a;
  b[0] = 102;         // two steps
  b[4 * 7 + 1] = 90;  // ten, on one pixel of 20,000
  b[4 * 9 + 3] = 0;   // coverage, likewise
  const PictureDifference difference = compare(a, b);
  EXPECT_TRUE(difference.same()) << difference.words();
  EXPECT_EQ(difference.max, 10);
  EXPECT_EQ(difference.coverage_differs, 1);
  EXPECT_EQ(difference.covered[0], 20000);
  EXPECT_EQ(difference.covered[1], 19999);
}

TEST(PictureDifference, MoreIsADifference) {
  const Picture a = grey(20000, 100);
  EXPECT_FALSE(compare(a, grey(20000, 101)).same());  // one step everywhere

  Picture spots = a, holes = a;
  for (std::size_t i = 0; i < 21; ++i) spots[4 * i] = 103;
  for (std::size_t i = 0; i < 3; ++i) holes[4 * i + 3] = 0;
  EXPECT_FALSE(compare(a, spots).same());
  EXPECT_FALSE(compare(a, holes).same());

  PictureDifference worst = compare(a, spots);
  worst.take_worse(compare(a, a));
  EXPECT_FALSE(worst.same());
}

}  // namespace
}  // namespace scanlit::bench
