// (4) A mesh that was cut covers what rays through the whole mesh hit.
#include "tests/stress/coverage_count.h"
#include "tests/stress/grid_mesh.h"
#include "tests/unit/clip_space.h"
#include "tests/unit/test_scene.h"

namespace scanlit::stress {
namespace {

using Real = long double;

template <class P, class Q, class R>
Real determinant(const P& p, const Q& q, const R& r) {
  return p[0] * (Real(q[1]) * r[2] - Real(q[2]) * r[1]) -
         p[1] * (Real(q[0]) * r[2] - Real(q[2]) * r[0]) +
         p[2] * (Real(q[0]) * r[1] - Real(q[1]) * r[0]);
}

/// The ray (x, y, -1) from the eye meets the triangle's front (1) or back (-1) beyond `near`.
int facing(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, Real x, Real y, Real near) {
  const Real ray[3] = {x, y, -1}, volume = determinant(a, b, c);
  if (volume == 0) return 0;
  const Real b0 = determinant(ray, b, c) / volume, b1 = determinant(a, ray, c) / volume,
             b2 = determinant(a, b, ray) / volume, inverse_distance = b0 + b1 + b2;
  const bool hit =
      b0 >= 0 && b1 >= 0 && b2 >= 0 && inverse_distance > 0 && inverse_distance <= 1 / near;
  return hit ? (volume < 0 ? 1 : -1) : 0;
}

TEST(Watertight, ClippedMeshCoversWhatRaysHit) {
  Property property{
      "a mesh cut by the near plane or the guard band covers what rays hit, each "
      "triangle as often and from the same side",
      "grids of 2 to 72 triangles from behind the eye to far beyond the guard band; "
      "pixels whose rays all hit the same, and pass the border on the same side, up to 1/64 pixel "
      "around",
      "faces too many", 400};
  constexpr int size = 24;
  const Viewport viewport{size, size};
  std::int64_t cut = 0;
  while (property.next()) {
    const Camera camera = test::eye_at_origin(0.1);
    const int columns = property.whole(1, 6), rows = property.whole(1, 6);
    const Grid grid(columns, rows, false, property);
    // A plane at any tilt, from about the eye to far away, with some vertices off it.
    const glm::dvec3 u = random_direction(property) * property.decades(-0.5, 4.5),
                     v = random_direction(property) * property.decades(-0.5, 2),
                     origin = random_direction(property) * 1.5 - 0.5 * (u + v);
    const double noise = property.any_of(0.0, 0.1, 1.0);
    std::vector<glm::vec3> positions;
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i)
        positions.emplace_back(origin + u * (double(i) / columns) + v * (double(j) / rows) +
                               noise * random_direction(property));
    const auto clip_space = test::in_clip_space(positions, camera, viewport);
    CoverageCount sum({0, 0, size, size});
    for (std::size_t i = 0; i < grid.indices.size(); i += 3) {
      const ClipVertex corners[3] = {clip_space[grid.indices[i]], clip_space[grid.indices[i + 1]],
                                     clip_space[grid.indices[i + 2]]};
      unsigned planes = 0;
      for (const ClipVertex& c : corners) planes |= test::outcode(c, viewport);
      std::vector<ClippedTriangle> pieces;
      clip(corners, planes, viewport, pieces);
      for (const ClippedTriangle& p : pieces) sum.add(p.vertices[0], p.vertices[1], p.vertices[2]);
      cut += planes != 0;
    }
    const std::vector<std::uint32_t> border = grid.border();
    for_each_pixel(sum.window(), [&](int x, int y) {
      int expected[9];
      std::vector<int> left(border.size());  // rays that pass there
      for (int k = 0; k < 9; ++k) {
        const Real sx = x + 0.5L + (k % 3 - 1) / 64.0L, sy = y + 0.5L + (k / 3 - 1) / 64.0L;
        const Real ray[3] = {sx * 2 / size - 1, 1 - sy * 2 / size, -1};
        expected[k] = 0;
        for (std::size_t i = 0; i < grid.indices.size(); i += 3)
          expected[k] += facing(positions[grid.indices[i]], positions[grid.indices[i + 1]],
                                positions[grid.indices[i + 2]], ray[0], ray[1], Real(0.1f));
        if (expected[k] != expected[0]) return;
        // Where one part of the border lies over another, as many are hit on either side of both;
        // but snapping may take the one past the pixel's centre and leave the other.
        for (std::size_t i = 0; i < border.size(); ++i)
          left[i] += determinant(positions[border[i]], positions[border[(i + 1) % border.size()]],
                                 ray) > 0;
      }
      if (std::ranges::any_of(left, [](int rays) { return rays % 9 != 0; })) return;
      property.measure(std::abs(sum.signed_sum(x, y) - expected[0]), "pixel ", x, " ", y);
    });
    EXPECT_EQ(property.worst(), 0);
  }
  property.expect_more_than(1000, cut);
}

}  // namespace
}  // namespace scanlit::stress
