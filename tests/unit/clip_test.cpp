// (3) to (5) Triangles that leave the near plane, the far plane or the guard band: cut where their
// neighbours cut, and inside the volume whatever digits cancellation takes.
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <set>

#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

/// Stages (3) to (6) of one object. Not moved: the frame refers to the rest.
struct Assembled {
  Scene scene;
  Camera camera;
  RenderSettings settings;
  Chunk chunk;
  Frame frame;

  Assembled(const std::shared_ptr<const Mesh>& mesh, const Camera& viewer, const Viewport& viewport)
      : scene(scene_of({object_of(mesh)})),
        camera(viewer),
        frame{.scene = scene,
              .camera = camera,
              .settings = settings,
              .viewport = viewport,
              .grid = make_tile_grid(viewport, 1),
              .draws = {},
              .chunks = {}} {
    Draw draw{};
    draw.object = &scene.objects[0];
    draw.mesh = mesh.get();
    draw.clusters = std::make_shared<MeshClusters>(make_clusters(*mesh));
    draw.clip_from_object =
        glm::mat4(clip_from_world(camera, double(viewport.width) / viewport.height));
    draw.draw_back_faces = true;
    frame.draws = {draw};
    settings.skips.unseen_triangles = false;  // a record of each
    chunk.draw = &frame.draws[0];
    chunk.end_cluster = std::uint32_t(draw.clusters->clusters.size());
    FrameStats stats;
    assemble(frame, chunk, stats);
  }
  Assembled(const Assembled&) = delete;
  Assembled& operator=(const Assembled&) = delete;
};

using Bits = std::array<std::uint32_t, 4>;

Bits bits(const ScreenVertex& v) {
  return {std::uint32_t(v.x), std::uint32_t(v.y), std::bit_cast<std::uint32_t>(v.depth),
          std::bit_cast<std::uint32_t>(v.inv_w)};
}

TEST(Clip, VertexStageDoesTheSameOneByOneAndInVectors) {
  std::mt19937_64 random(1);
  const Viewport viewport{1000, 700};
  std::vector<glm::vec3> positions(999);
  for (glm::vec3& p : positions) p = delicate_position(random, viewport, 0.1f);
  const Assembled all(triangle_soup(positions), eye_at_origin(), viewport);
  const Draw& draw = all.frame.draws[0];
  for (const Cluster& cluster : draw.clusters->clusters) {
    ClusterVertices vertices;
    transform_vertices(draw, cluster, viewport, vertices);
    unsigned any = 0;
    for (std::size_t i = 0; i < cluster.vertex_count; ++i) {
      any |= vertices.outcodes[i];
      EXPECT_EQ(vertices.x[i], vertices.screen[i].x);
      EXPECT_EQ(vertices.y[i], vertices.screen[i].y);
      if (vertices.outcodes[i] != 0) continue;
      const std::uint32_t v = draw.clusters->vertices[cluster.first_vertex + i];
      const ScreenVertex one = project(transform(draw, positions[v]), viewport);
      EXPECT_EQ(bits(one), bits(vertices.screen[i])) << v;
    }
    EXPECT_EQ(any, vertices.any_outcode);
  }
}

TEST(Clip, BothTrianglesOfAnEdgeCutItAtTheSamePoints) {
  int cuts = 0;
  EXPECT_TRUE(holds(20000, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const Viewport viewport{*rc::gen::element(64, 100, 1000, 1920, 16384),
                            *rc::gen::element(48, 1080, 16384)};
    const float near = *rc::gen::element(0.1f, 0.25f);
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i < 4; ++i)
      mesh->positions.push_back(delicate_position(random, viewport, near));
    // An edge that lies in a side of the guard band is never near the picture, and may be cut there
    // by rounding alone.
    const auto at_side = [&](const glm::vec3& p) {
      const float reach = viewport.guard_x() * p.z * float(viewport.width) / float(viewport.height);
      return std::abs(std::abs(p.x) - std::abs(reach)) <= 1e-5f * std::abs(reach);
    };
    if (at_side(mesh->positions[0]) && at_side(mesh->positions[1])) return;
    mesh->normals.assign(4, {0, 0, 1});
    mesh->indices = {0, 1, 2, 1, 0, 3};  // 0-1 is shared
    const Camera camera = eye_at_origin(near, *rc::gen::element(infinity, 100.0));
    const Assembled both(mesh, camera, viewport);

    // What lies on the shared edge has no share in the third corner.
    std::set<Bits> on_edge[2];
    bool drawn[2] = {false, false};
    for (const DrawnTriangle& t : both.chunk.triangles) {
      drawn[t.triangle] = true;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        // A triangle that was not cut has the edge's ends as they are.
        const bool at_edge = t.piece == DrawnTriangle::not_cut
                                 ? corner < 2
                                 : both.chunk.pieces[t.piece].barycentric[corner][2] == 0;
        if (at_edge) on_edge[t.triangle].insert(bits(t.vertices[corner]));
      }
    }
    if (!drawn[0] || !drawn[1]) return;  // one was outside altogether
    cuts += int(on_edge[0].size());
    RC_ASSERT(on_edge[0] == on_edge[1]);
  }));
  EXPECT_GT(cuts, 10000);
}

/// The clip-space depth of distance w, as camera.cpp has it.
double clip_depth(double w, double near, double far) {
  return std::isinf(far) ? near : near * (far - w) / (far - near);
}

/// As the vertex stage decides it; all six planes of a triangle none of whose corners is inside.
unsigned planes_to_cut(const ClipVertex (&triangle)[3], const Viewport& viewport) {
  unsigned any = 0, all = ~0u;
  for (const ClipVertex& v : triangle) {
    const float x = viewport.guard_x() * v.w, y = viewport.guard_y() * v.w;
    const unsigned code = outside_near * !(v.z <= v.w) | outside_far * !(v.z >= 0) |
                          outside_left * !(-x <= v.x) | outside_right * !(v.x <= x) |
                          outside_bottom * !(-y <= v.y) | outside_top * !(v.y <= y);
    any |= code, all &= code;
  }
  return all ? 0 : any;
}

TEST(Clip, PiecesLieInTheVolumeHoweverFarTheCornersWere) {
  std::mt19937_64 random(3);
  // Fourteen decades below 1 to thirty above: cancellation may take every digit of a coordinate.
  std::uniform_real_distribution<double> exponent(-14, 30), sign(-1, 1), decades(-12, 2),
      depth(0, 14);
  const auto coordinate = [&] { return sign(random) * std::pow(10.0, exponent(random)); };
  int cut = 0;
  for (int i = 0; i < 300000; ++i) {
    const Viewport viewport{i % 3 ? 1920 : 16384, i % 5 ? 1080 : 1};
    const double near = std::pow(10.0, decades(random));
    const double far = i % 2 ? infinity : near * (1.01 + std::pow(10.0, depth(random)));
    ClipVertex triangle[3];
    for (ClipVertex& v : triangle) {
      const double w = coordinate();
      v = {float(coordinate()), float(coordinate()), float(clip_depth(w, near, far)), float(w)};
    }
    const unsigned planes = planes_to_cut(triangle, viewport);
    std::vector<ClippedTriangle> pieces;
    if (planes) clip(triangle, planes, viewport, pieces);
    cut += !pieces.empty();
    ASSERT_LE(pieces.size(), 7u);
    for (const ClippedTriangle& piece : pieces) {
      for (int corner = 0; corner < 3; ++corner) {
        const float* b = piece.barycentric[corner];
        ASSERT_NEAR(double(b[0]) + b[1] + b[2], 1, 2e-7) << i;
        ASSERT_TRUE(b[0] >= 0 && b[1] >= 0 && b[2] >= 0) << i;
        const ScreenVertex& v = piece.vertices[corner];
        ASSERT_TRUE(v.depth >= 0 && v.depth <= 1) << i << ": " << v.depth;
        ASSERT_TRUE(v.inv_w > 0 && v.inv_w <= 1.1e13f) << i << ": " << v.inv_w;
        // The sides of the guard band, (4): at most 2^15 pixels beyond the picture's centre.
        ASSERT_LE(std::abs(v.x - viewport.width * half_pixel), 1 << 23) << i;
        ASSERT_LE(std::abs(v.y - viewport.height * half_pixel), 1 << 23) << i;
      }
    }
  }
  EXPECT_GT(cut, 50000);
}

/// Whether a piece has a corner where x and w of clip space are these, to a few of float's digits.
testing::AssertionResult has_corner(const std::vector<ClippedTriangle>& pieces, double x, double w,
                                    const Viewport& viewport) {
  auto result = testing::AssertionFailure();
  for (const ClippedTriangle& piece : pieces)
    for (const ScreenVertex& v : piece.vertices) {
      const double screen_x = viewport.width * half_pixel * (1 + x / w);
      if (std::abs(v.x - screen_x) <= 1 && std::abs(double(v.inv_w) * w - 1) < 1e-6)
        return testing::AssertionSuccess();
      result << v.x << " (" << screen_x << "), w " << 1 / v.inv_w << " (" << w << ")\n";
    }
  return result;
}

TEST(Clip, EachPlaneCutsAnEdgeWhereTheyMeet) {
  const Viewport viewport{64, 48};
  const float gx = viewport.guard_x(), gy = viewport.guard_y();
  const struct {
    Outside plane;
    ClipVertex beyond, meeting;  // half-way to it from (0, 0, .5, 1)
  } cases[] = {{outside_near, {0.2f, 0.4f, 1.5f, 1}, {0.1f, 0.2f, 1, 1}},
               {outside_far, {0.2f, 0.4f, -0.5f, 1}, {0.1f, 0.2f, 0, 1}},
               {outside_left, {-2 * gx, 0.4f, 0.5f, 1}, {-gx, 0.2f, 0.5f, 1}},
               {outside_right, {2 * gx, 0.4f, 0.5f, 1}, {gx, 0.2f, 0.5f, 1}},
               {outside_bottom, {0.2f, -2 * gy, 0.5f, 1}, {0.1f, -gy, 0.5f, 1}},
               {outside_top, {0.2f, 2 * gy, 0.5f, 1}, {0.1f, gy, 0.5f, 1}}};
  for (const auto& [plane, beyond, meeting] : cases) {
    std::vector<ClippedTriangle> pieces;
    clip({{0, 0, 0.5f, 1}, {0.3f, 0.1f, 0.5f, 1}, beyond}, plane, viewport, pieces);
    const Bits expected = bits(project(meeting, viewport));
    int found = 0;
    for (const ClippedTriangle& piece : pieces)
      for (const ScreenVertex& v : piece.vertices) found += bits(v) == expected;
    EXPECT_EQ(pieces.size(), 2u) << plane;
    EXPECT_GT(found, 0) << plane;
  }
}

TEST(Clip, CutPointsKeepTheirDigitsHoweverFarTheOtherEndIs) {
  const Viewport viewport{64, 64};
  for (const float distance : {1e3f, 1e9f, 1e15f}) {
    // From far before the eye to far behind it: cut at the near plane, w = 0.1.
    const float before = 1.1f * distance;
    std::vector<ClippedTriangle> pieces;
    clip({{0.3f, 0, 0.1f, before}, {0.4f, 0, 0.1f, -distance}, {0, 1, 0.1f, 1}}, outside_near,
         viewport, pieces);
    const double t = (double(before) - double(0.1f)) / (double(before) + double(distance));
    EXPECT_TRUE(has_corner(pieces, 0.3 + t * 0.1, double(0.1f), viewport)) << distance;

    // From far away to close by, beyond the right side of the guard band: cut close by.
    const float beyond = 10.7f * viewport.guard_x();
    pieces.clear();
    clip({{0, 0, 0.1f, distance}, {beyond, 0, 0.1f, 1}, {0, 1, 0.1f, 1}}, outside_right, viewport,
         pieces);
    const double excess = beyond / double(viewport.guard_x()) - 1;
    const double s = excess / (excess + double(distance));
    EXPECT_TRUE(has_corner(pieces, beyond * (1 - s), 1 + s * (distance - 1.0), viewport))
        << distance;
  }
}

}  // namespace
}  // namespace scanlit
