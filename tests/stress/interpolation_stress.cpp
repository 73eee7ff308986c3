// (7) to (9) Depth and attributes across a triangle, where distances differ by as much as they can.
#include <algorithm>
#include <cmath>

#include "tests/stress/property.h"
#include "tests/unit/test_scene.h"

namespace scanlit::stress {
namespace {

using Real = long double;

constexpr int size = 24;

/// The screen's x and y of a camera of test::eye_at_origin, as a ray (x, y, -1).
Real ray_x(Real x) { return x * 2 / size - 1; }
Real ray_y(Real y) { return 1 - y * 2 / size; }

/// Shows the object position as diffuse radiance, whichever way the triangle faces.
test::Picture picture_of_points(const std::vector<glm::vec3>& corners, double near) {
  Scene scene = test::scene_of({test::object_of(test::triangle_soup(corners), test::ShowPoint())});
  scene.lights.push_back(scene.lights[0]);
  scene.lights[1].direction = {0, 0, -1};
  return test::picture_of(scene, test::eye_at_origin(near), size, size);
}

template <class Use>
void for_each_point(const test::Picture& picture, const Use& use) {
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (picture.triangle(x, y) != no_id)
        use(x, y, &picture.framebuffer.diffuse[3 * picture.index(x, y)]);
}

TEST(Interpolation, WeightsOverAMillionfoldDistance) {
  Property property{"interpolated positions equal ray and plane through the snapped corners",
                    "one triangle, corners at distances of 1 to 1e6 times the nearest",
                    "of the largest coordinate (allowed: 1e-6)", 4000};
  const double near = 1e-4;
  Draw draw{};
  draw.clip_from_object = glm::mat4(clip_from_world(test::eye_at_origin(near), 1));
  while (property.next()) {
    const double decades = property.any_of(0.0, 1.0, 3.0, 6.0, 6.0);
    std::vector<glm::vec3> corners;
    Real p[3][3], largest = 0;
    for (auto& row : p) {
      const double w = 0.01 * property.decades(0, decades);
      const glm::vec3 corner(property.uniform(-2, 2) * w, property.uniform(-2, 2) * w, -w);
      const ScreenVertex v = project(transform(draw, corner), {size, size});
      // Snapping is not this property's: the plane is that of the snapped corners.
      row[0] = ray_x(v.x / Real(256)) * -corner.z, row[1] = ray_y(v.y / Real(256)) * -corner.z;
      row[2] = corner.z;
      corners.push_back(corner);
    }
    const auto determinant = [](const Real* a, const Real* b, const Real* c) {
      return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    for (int k = 0; k < 3; ++k)
      for (const glm::vec3& corner : corners)
        largest = std::max(largest, Real(std::abs(corner[k])));
    for_each_point(picture_of_points(corners, near), [&](int x, int y, const float* point) {
      const Real ray[3] = {ray_x(x + 0.5L), ray_y(y + 0.5L), -1};
      const Real b[3] = {determinant(ray, p[1], p[2]), determinant(p[0], ray, p[2]),
                         determinant(p[0], p[1], ray)};
      const Real sum = b[0] + b[1] + b[2];
      for (int k = 0; k < 3; ++k) {
        const Real exact =
            (b[0] * corners[0][k] + b[1] * corners[1][k] + b[2] * corners[2][k]) / sum;
        property.measure(double(std::abs(point[k] - exact) / largest), "pixel ", x, " ", y,
                         ", distances over ", decades, " decades");
      }
    });
    EXPECT_LE(property.worst(), 1e-6);
  }
}

TEST(Interpolation, ThroughTheEyePlane) {
  Property property{"a point of a triangle that is cut lies on its pixel's ray",
                    "one triangle with corners behind the eye, in its plane, at it, on the near "
                    "plane, at the guard band and 1e5 away; of those that are cut",
                    "of the allowed distance (1/32 pixel, and 8 roundings of the farthest corner, "
                    "seen from the point)",
                    4000};
  std::int64_t cut = 0;
  while (property.next()) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 3; ++i)
      corners.push_back(test::delicate_position(property.random(), {size, size}, 0.1f));
    const test::Picture picture = picture_of_points(corners, 0.1);
    if (picture.stats.clipped == 0) continue;
    ++cut;
    const auto length = [](const glm::vec3& v) { return std::hypot(v.x, v.y, v.z); };
    const double reach = std::max({length(corners[0]), length(corners[1]), length(corners[2])});
    for_each_point(picture, [&](int x, int y, const float* point) {
      const double sx = (1 - point[0] / point[2]) * size / 2;
      const double sy = (1 + point[1] / point[2]) * size / 2;
      const double off = std::max(std::abs(sx - x - 0.5), std::abs(sy - y - 0.5));
      const double allowed = 1.0 / 32 + 8 * 0x1p-24 * reach / -point[2] * size;
      property.measure(off / allowed, "pixel ", x, " ", y, ", reach ", reach, ", distance ",
                       -point[2]);
    });
    EXPECT_LE(property.worst(), 1);
  }
  property.expect_more_than(500, cut);
}

/// Two parallel squares, the second one farther by a share e, through the point at `distance` on
/// the view's axis; drawn in either order. Whether every pixel shows the nearer one.
bool nearer_is_seen(Property& property, double near, double distance, double tilt, double e) {
  const double turn = property.uniform(0, 6.3);
  const glm::dvec3 across(std::cos(turn), std::sin(turn), 0),
      up(-std::sin(turn) * std::cos(tilt), std::cos(turn) * std::cos(tilt), std::sin(tilt));
  std::vector<glm::vec3> corners;
  const bool far_first = property.coin();
  for (const bool far : {far_first, !far_first}) {
    const double d = distance * (far ? 1 + e : 1);
    const auto corner = [&](double i, double j) {
      corners.emplace_back(glm::dvec3(0, 0, -d) + d * (i * across + j * up));
    };
    corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5);
    corner(-0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5);
  }
  const test::Picture picture =
      test::picture_of(test::scene_of({test::object_of(test::triangle_soup(corners))}),
                       test::eye_at_origin(near), size, size);
  for (const std::uint32_t id : picture.framebuffer.triangle_id)
    if (id != no_id && (id < 2) == far_first) return false;
  return picture.stats.covered_pixels > 0;
}

TEST(Depth, TheThresholdOfDepthFightingIsRelative) {
  // Depth n / d is stored with 24 bits of its own size, so what can be told apart is a share of the
  // distance, near or far. Where a plane is tilted, corners that snap apart count besides: a unit
  // of 1/256 pixel moves it by so much of its slope.
  Property property{
      "of two parallel planes the nearer one is seen at every pixel, once they are so "
      "far apart",
      "near plane 1e-6 to 1e3, distances from it to 1e9 times as far, facing or "
      "tilted by up to 60 degrees",
      "of the allowed share of the distance (1e-6; tilted, 1/256 pixel besides)", 250};
  while (property.next()) {
    const double near = property.decades(-6, 3), distance = near * property.decades(0.5, 9);
    const double tilt = property.coin() ? 0 : property.uniform(0, 1.05);
    int bits = 8;  // 2^-bits is enough, all coarser ones were
    while (bits < 26 && nearer_is_seen(property, near, distance, tilt, std::exp2(-bits - 1)))
      ++bits;
    const double threshold = std::exp2(-bits);
    const double allowed = 1e-6 + 2 * std::tan(tilt) / (subpixel * size / 2);
    property.measure(threshold / allowed, threshold, " of distance ", distance, ", near ", near,
                     ", tilt ", tilt);
    EXPECT_LE(property.worst(), 1);
  }
}

TEST(Depth, ErrorIsAShareOfTheDepth) {
  Property property{"stored depth equals near / distance",
                    "a plane that faces the camera, near plane 1e-6 to 1e3, distances from it to "
                    "1e12 times as far",
                    "of the depth (allowed: 3e-7)", 3000};
  while (property.next()) {
    const double near = property.decades(-6, 3), distance = near * property.decades(0.01, 12);
    const float z = float(-distance), r = 2 * z;
    const auto corners = std::vector<glm::vec3>{{-r, -r, z}, {r, r, z}, {r, -r, z}};
    const test::Picture picture =
        test::picture_of(test::scene_of({test::object_of(test::triangle_soup(corners))}),
                         test::eye_at_origin(near), size, size);
    const double exact = near / double(-z);
    for_each_point(picture, [&](int x, int y, const float*) {
      const double depth = double(picture.framebuffer.depth[picture.index(x, y)]);
      property.measure(std::abs(depth / exact - 1), "near ", near, ", distance ", distance);
    });
    EXPECT_LE(property.worst(), 3e-7);
  }
}

}  // namespace
}  // namespace scanlit::stress
