// (3) to (7) Watertight, as theorems that hold after snapping whatever was rounded before it: a
// closed mesh covers each pixel as often with front faces as with back faces, and a disc as often
// as its border goes around it.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/stress/coverage_count.h"
#include "tests/stress/grid_mesh.h"
#include "tests/unit/clip_space.h"
#include "tests/unit/test_scene.h"

namespace scanlit::stress {
namespace {

using test::in_clip_space, test::outcode;

Viewport random_viewport(Property& property) {
  const auto side = [&] { return property.any_of(1, 2, 3, 17, 64, 200, 1000, 4096, 16384); };
  const int width = side();
  return {width, side()};
}

/// A perspective or parallel view of the unit sphere about the origin, all in units of `scale` and
/// moved by `offset`.
Camera random_camera(Property& property, double scale, const glm::dvec3& offset) {
  Camera camera;
  const glm::dvec3 back = random_direction(property);
  const double distance = property.uniform(2.5, 10);
  camera.target = offset + scale * 0.3 * random_direction(property);
  camera.eye = camera.target + scale * distance * back;
  camera.up = random_direction(property);
  camera.projection = property.coin() ? Projection::perspective : Projection::orthographic;
  camera.fov_deg = property.uniform(5, 120);
  camera.height = scale * property.decades(-1, 1);
  camera.near = scale * 0.01;
  camera.far = scale * 100;
  return camera;
}

/// 64 x 64 pixels about a vertex, as far as the picture reaches.
Rect window_at(const ScreenVertex& v, const Viewport& viewport) {
  const int x = std::clamp((v.x >> 8) - 32, 0, std::max(0, viewport.width - 64));
  const int y = std::clamp((v.y >> 8) - 32, 0, std::max(0, viewport.height - 64));
  return {x, y, std::min(x + 64, viewport.width), std::min(y + 64, viewport.height)};
}

CoverageCount count(const std::vector<ScreenVertex>& screen,
                    const std::vector<std::uint32_t>& indices, const Rect& window) {
  CoverageCount result(window);
  for (std::size_t i = 0; i < indices.size(); i += 3)
    result.add(screen[indices[i]], screen[indices[i + 1]], screen[indices[i + 2]]);
  return result;
}

/// Quadrangles on a side of a closed mesh: up to a million triangles where there is time.
int largest_side() { return effort().seconds_each > 30 ? 700 : 150; }

TEST(Watertight, ClosedMeshCancels) {
  Property property{"front faces minus back faces of a closed mesh is zero at every pixel",
                    "18 to 1e6 triangles (quick: 45,000), smooth to tangled, scales 1e-6 to 1e6, "
                    "offsets to 1e7 times the size, pictures of 1 to 16384",
                    "faces too many", 150};
  std::int64_t covered = 0;
  while (property.next()) {
    const int columns = int(property.decades(0.48, std::log10(largest_side())));
    const int rows = int(property.decades(0.48, std::log10(largest_side())));
    const double scale = property.decades(-6, 6), away = property.any_of(0.0, 1.0, 1e3, 1e5, 1e7);
    const glm::dvec3 offset = scale * away * random_direction(property);
    const Viewport viewport = random_viewport(property);
    const Camera camera = random_camera(property, scale, offset);
    const Grid grid(columns, rows, true, property);
    std::vector<glm::vec3> positions;
    for (const auto& p : torus_positions(columns, rows, property.uniform(0.05, 0.5),
                                         property.any_of(0.0, 1e-3, 0.1, 1.0), property))
      positions.emplace_back(offset + scale * p);
    std::vector<ScreenVertex> screen;
    for (const ClipVertex& v : in_clip_space(positions, camera, viewport))
      if (outcode(v, viewport) == 0) screen.push_back(project(v, viewport));
    if (screen.size() != positions.size()) continue;
    const CoverageCount sum = count(screen, grid.indices, window_at(screen[0], viewport));
    for_each_pixel(sum.window(), [&](int x, int y) {
      property.measure(std::abs(sum.signed_sum(x, y)), "pixel ", x, " ", y);
      covered += sum.faces(x, y) > 0;
    });
    EXPECT_EQ(property.worst(), 0);
  }
  property.expect_more_than(10000, covered);
}

TEST(Watertight, DiscCoversWhatItsBorderGoesAround) {
  Property property{"a disc's front faces minus back faces are its border's winding number",
                    "fans and grids of 1 to 800 triangles on the screen, some flipped, slivers of "
                    "aspect 1 to 1e9, random w from 1 to 1e6, pictures of 1 to 16384",
                    "faces too many", 1500};
  while (property.next()) {
    const Viewport viewport = random_viewport(property);
    const int columns = property.whole(1, 20),
              rows = property.any_of(1, 1, 2, property.whole(1, 20));
    const double aspect = property.decades(0, 9), size = property.decades(-1, 3.5);
    const double noise = property.any_of(0.0, 0.2, 1.0, 3.0), turn = property.uniform(0, 6.3);
    const double decades_of_w = property.any_of(0.0, 1.0, 6.0);
    const double x0 = property.uniform(0, viewport.width),
                 y0 = property.uniform(0, viewport.height);
    std::vector<ScreenVertex> screen;
    const Grid grid(columns, rows, false, property);
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) {
        const double x = (i + noise * property.uniform(-0.5, 0.5)) / columns * size;
        const double y = (j + noise * property.uniform(-0.5, 0.5)) / rows * size / aspect;
        const double sx = x0 + x * std::cos(turn) - y * std::sin(turn);
        const double sy = y0 + x * std::sin(turn) + y * std::cos(turn);
        const double w = property.decades(0, decades_of_w);
        screen.push_back(
            project({float((2 * sx / viewport.width - 1) * w),
                     float((1 - 2 * sy / viewport.height) * w), float(0.5 * w), float(w)},
                    viewport));
      }
    std::vector<ScreenVertex> border;
    for (const std::uint32_t v : grid.border()) border.push_back(screen[v]);
    const CoverageCount sum = count(screen, grid.indices, window_at(screen[0], viewport));
    for_each_pixel(sum.window(), [&](int x, int y) {
      const int expected = winding_number(border, x, y);
      property.measure(std::abs(sum.signed_sum(x, y) - expected), "pixel ", x, " ", y);
    });
    EXPECT_EQ(property.worst(), 0);
  }
}

TEST(Watertight, FrontAndBackOfAClosedMeshCoverTheSameSamples) {
  Property property{
      "in whole pictures, a closed mesh covers the same share of each pixel with its "
      "front faces alone as with its back faces alone, whatever is culled",
      "as above, 1 to 16 samples, pictures up to 300 x 200 and 16384 x 4; whole "
      "clusters in and out of view",
      "of a pixel", 60};
  std::int64_t covered = 0;
  while (property.next()) {
    const int side = property.whole(0, 20) == 0 ? largest_side() : 60;
    const int columns = property.whole(3, side), rows = property.whole(3, side);
    const double scale = property.decades(-6, 6);
    const glm::dvec3 offset =
        scale * property.any_of(0.0, 1.0, 1e3, 1e5) * random_direction(property);
    int width = property.whole(1, 300), height = property.whole(1, 200);
    if (property.whole(0, 9) == 0) width = 16384, height = property.whole(1, 4);
    if (property.coin()) std::swap(width, height);
    const Camera camera = random_camera(property, scale, offset);
    const Grid grid(columns, rows, true, property);
    std::vector<glm::vec3> positions;
    for (const auto& p : torus_positions(columns, rows, property.uniform(0.05, 0.5),
                                         property.any_of(0.0, 1e-3, 0.1, 1.0), property))
      positions.emplace_back(offset + scale * p);
    std::vector<std::uint32_t> reversed(grid.indices.rbegin(), grid.indices.rend());
    const RenderSettings settings = test::with_samples(property.any_of(1, 4, 8, 16));
    const auto picture = [&](const std::vector<std::uint32_t>& indices) {
      Object object = test::object_of(mesh_of(positions, indices));
      object.sides = Sides::front;
      return test::picture_of(test::scene_of({object}), camera, width, height, settings);
    };
    const test::Picture front = picture(grid.indices), back = picture(reversed);
    for_each_pixel({0, 0, width, height}, [&](int x, int y) {
      const float a = front.colour(x, y)[3], b = back.colour(x, y)[3];
      property.measure(std::abs(a - b), "pixel ", x, " ", y, " of ", width, " x ", height);
      covered += a > 0;
    });
    EXPECT_EQ(property.worst(), 0);
  }
  property.expect_more_than(10000, covered);
}

TEST(Watertight, SnappedVerticesAreWhereTheyShouldBe) {
  Property property{
      "a vertex is snapped to within half a unit of 1/256 pixel of its exact place, "
      "and what float takes",
      "scales 1e-6 to 1e6, offsets to 1e7 times the size, pictures of 1 to 16384; "
      "what float takes: 16 roundings of the farthest coordinate, seen in pixels",
      "of the allowed distance", 20000};
  while (property.next()) {
    const double scale = property.decades(-6, 6), away = property.any_of(0.0, 1.0, 1e3, 1e5, 1e7);
    const glm::dvec3 offset = scale * away * random_direction(property);
    const Viewport viewport = random_viewport(property);
    const Camera camera = random_camera(property, scale, offset);
    const glm::vec3 position(offset + scale * random_direction(property));
    const ClipVertex clip_position = in_clip_space({position}, camera, viewport)[0];
    if (outcode(clip_position, viewport) != 0) continue;
    const ScreenVertex v = project(clip_position, viewport);
    const double aspect = double(viewport.width) / viewport.height;
    const glm::dvec4 exact = clip_from_world(camera, aspect) * glm::dvec4(position, 1.0);
    const double x = (1 + exact.x / exact.w) * viewport.width * 128,
                 y = (1 - exact.y / exact.w) * viewport.height * 128;
    // A coordinate's rounding is 2^-24 of the largest number in its sum, and so in pixels as much
    // as the size of a pixel where the vertex is allows.
    const glm::dmat4 m = clip_from_world(camera, aspect);
    const auto sum = [&](int row) {
      double largest = 0;
      for (int i = 0; i < 4; ++i)
        largest += std::abs(m[i][row] * (i < 3 ? double(position[i]) : 1));
      return largest;
    };
    const double rounding = 16 * 0x1p-24;
    const auto allowed = [&](int row, double pixels, double value) {
      return 0.5 + rounding * 128 * pixels *
                       ((sum(row) + std::abs(value / exact.w) * sum(3)) / std::abs(exact.w) + 1);
    };
    const double off = std::max(std::abs(v.x - x) / allowed(0, viewport.width, exact.x),
                                std::abs(v.y - y) / allowed(1, viewport.height, exact.y));
    property.measure(off, "offset ", away, " sizes, ", viewport.width, " x ", viewport.height);
    EXPECT_LE(off, 1);
  }
}

}  // namespace
}  // namespace scanlit::stress
