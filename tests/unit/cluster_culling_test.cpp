// What is told of a cluster from its bounds holds for each of its triangles, put through the exact
// path: transform, clip, project, snap.
#include "rasterizer/cluster_culling.h"

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "rasterizer/scan_conversion.h"
#include "rasterizer/shapes.h"
#include "tests/unit/clip_space.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

Draw draw_of(const Mesh& mesh, const glm::mat4& world_from_object, const Camera& camera,
             const Viewport& viewport) {
  const double aspect = double(viewport.width) / viewport.height;
  const glm::dmat4 m(world_from_object);
  return {.object = nullptr,
          .mesh = &mesh,
          .clusters = {},
          .index = 0,
          .clip_from_object = glm::mat4(clip_from_world(camera, aspect) * m),
          .normal_from_object = glm::mat3(1),
          .draw_back_faces = false,
          .mirrored = glm::determinant(glm::dmat3(m)) < 0,
          .illumination = {}};
}

/// What becomes of one triangle, or of the pieces that it is cut into.
struct Fate {
  unsigned outcodes = 0;  // of all its vertices
  bool in_picture = false, front = false, back = false;
  Rect pixels{};      // that a triangle which is not cut may touch
  float nearest = 0;  // of its corners' depths
};

Fate fate(const Draw& draw, const Viewport& viewport, std::uint32_t triangle) {
  ClipVertex corners[3];
  unsigned any = 0, all = ~0u;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::uint32_t vertex = draw.mesh->indices[3 * std::size_t(triangle) + c];
    corners[c] = transform(draw, draw.mesh->positions[vertex]);
    const unsigned code = outcode(corners[c], viewport);
    any |= code, all &= code;
  }
  Fate result{.outcodes = any};
  if (all != 0 || any & out_of_range) return result;

  std::vector<ClippedTriangle> pieces;
  if (any != 0) {
    clip(corners, any, viewport, pieces);
  } else {
    ClippedTriangle& whole = pieces.emplace_back();
    for (int c = 0; c < 3; ++c) whole.vertices[c] = project(corners[c], viewport);
  }
  for (const ClippedTriangle& piece : pieces) {
    const auto& [a, b, c] = piece.vertices;
    const std::int64_t twice_area = screen_triangle(a, b, c).twice_area;
    if (twice_area == 0) continue;
    ((twice_area < 0) != draw.mirrored ? result.back : result.front) = true;
    // Pixels that any sample position of which may be covered.
    const auto [x_min, x_max] = std::minmax({a.x, b.x, c.x});
    const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
    result.in_picture |= x_max >= 0 && y_max >= 0 && x_min < viewport.width * subpixel &&
                         y_min < viewport.height * subpixel;
    result.pixels = {x_min >> 8, y_min >> 8, (x_max >> 8) + 1, (y_max >> 8) + 1};
    result.nearest = std::max({a.depth, b.depth, c.depth});
  }
  return result;
}

/// Whether a triangle without outcodes keeps within what was said of its cluster or object.
bool within(const ScreenBounds& bounds, const Fate& f) {
  return f.pixels.empty() ||
         (united(bounds.pixels, f.pixels) == bounds.pixels && double(f.nearest) < bounds.nearest);
}

using Counts = std::map<ClusterView, int>;  // of clusters

/// Every triangle of every cluster is as its cluster was said to be.
testing::AssertionResult culled_rightly(const MeshClusters& mesh, const Draw& draw,
                                        const Viewport& viewport, Counts& counts) {
  const ClusterCuller culler(draw, viewport);
  const ClusterView whole = culler.view(mesh.bounds);
  const auto bounds_of = [&](ClusterView view, const Sphere& sphere) {
    return view == ClusterView::inside ? culler.screen_bounds(sphere) : ScreenBounds{};
  };
  const ScreenBounds whole_bounds = bounds_of(whole, mesh.bounds);
  for (const Cluster& cluster : mesh.clusters) {
    const ClusterView view = culler.view(cluster);
    ++counts[view];
    const ScreenBounds bounds =
        bounds_of(view, {glm::dvec3(cluster.centre), double(cluster.radius)});
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
      const std::uint32_t triangle = mesh.triangles[cluster.first_triangle + i];
      const Fate f = fate(draw, viewport, triangle);
      const char* wrong = nullptr;
      if ((view == ClusterView::inside && !within(bounds, f)) ||
          (whole == ClusterView::inside && !within(whole_bounds, f)))
        wrong = "leaves its bounds on the screen";
      if (view == ClusterView::outside && f.in_picture) wrong = "of an outside cluster is seen";
      if (whole == ClusterView::outside && f.in_picture) wrong = "of an outside object is seen";
      if (view == ClusterView::back_facing && f.front) wrong = "faces the viewer";
      if ((view == ClusterView::back_facing || view == ClusterView::inside ||
           whole == ClusterView::inside) &&
          f.outcodes != 0)
        wrong = "has an outcode";
      if (wrong) return testing::AssertionFailure() << "triangle " << triangle << ' ' << wrong;
    }
  }
  return testing::AssertionSuccess();
}

float random_float(float low, float high) {
  return low + (high - low) * float(*rc::gen::inRange(0, 1 << 20)) * 0x1p-20f;
}
glm::vec3 random_vector(float size) {
  const float x = random_float(-size, size), y = random_float(-size, size);
  return {x, y, random_float(-size, size)};
}
/// 10^low .. 10^high
float random_scale(float low, float high) { return std::pow(10.0f, random_float(low, high)); }

/// Smooth, rough, needle-thin, or loose triangles; about the origin or far from it.
Mesh random_mesh() {
  Mesh mesh = make_shape(*rc::gen::element<std::string>("sphere:40", "torus:30", "icosphere:12",
                                                        "plane:20", "cube:8", "cone:12"));
  std::mt19937_64 random(*rc::gen::inRange(0u, 1000000u));
  std::uniform_real_distribution<float> unit(-1, 1);
  const float roughness = *rc::gen::element(0.0f, 0.0f, 1e-3f, 0.3f);
  const glm::vec3 offset =
      *rc::gen::element(0, 0, 1) ? random_vector(random_scale(0, 4)) : glm::vec3(0);
  const glm::vec3 stretch(1, *rc::gen::element(1.0f, 1.0f, 1e-3f),
                          *rc::gen::element(1.0f, 1.0f, 30.0f));
  for (glm::vec3& p : mesh.positions)
    p = (p + roughness * glm::vec3(unit(random), unit(random), unit(random))) * stretch + offset;
  return mesh;
}

struct View {
  Camera camera;
  Viewport viewport;
  glm::mat4 world_from_object;
};

/// A camera at any distance from the mesh, also within it, that looks roughly towards it.
View random_view(const Sphere& bounds) {
  View view;
  view.viewport = {*rc::gen::inRange(1, 2000), *rc::gen::inRange(1, 2000)};
  const glm::vec3 scale =
      random_scale(-2, 2) *
      (*rc::gen::arbitrary<bool>() ? glm::vec3(1) : glm::vec3(random_scale(-1, 1), 1, -1));
  glm::mat4 m = glm::translate(glm::mat4(1), random_vector(random_scale(-2, 3)));
  m = glm::rotate(m, random_float(0, 6.28f),
                  glm::normalize(random_vector(1) + glm::vec3(0, 1.01f, 0)));
  view.world_from_object = glm::scale(m, scale);

  const glm::dvec3 centre(view.world_from_object * glm::vec4(bounds.centre, 1));
  const double size =
      bounds.radius * double(std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)}));
  const double distance = size * double(random_scale(-1, *rc::gen::element(0.5f, 3.0f)));
  Camera& camera = view.camera;
  camera.target = centre + size * glm::dvec3(random_vector(*rc::gen::element(0.1f, 2.0f)));
  camera.eye = camera.target +
               distance * glm::normalize(glm::dvec3(random_vector(1)) + glm::dvec3(0, 0, 1.01));
  camera.up = {0, 1, 0.1};
  camera.fov_deg = double(random_float(1, 120));
  camera.height = size * double(random_scale(-1, 1));
  camera.near = distance * double(random_scale(-4, 0));
  camera.far = camera.near + distance * double(random_scale(-1, 1));
  if (*rc::gen::arbitrary<bool>())
    camera.projection = Projection::orthographic;
  else if (*rc::gen::arbitrary<bool>())
    camera.far = infinity;
  return view;
}

TEST(ClusterCulling, NeverContradictsATriangle) {
  Counts counts;
  EXPECT_TRUE(holds(1500, [&] {
    const Mesh mesh = random_mesh();
    const MeshClusters clusters = make_clusters(mesh);
    for (int i = 0; i < 4; ++i) {
      const View view = random_view(clusters.bounds);
      const Draw draw = draw_of(mesh, view.world_from_object, view.camera, view.viewport);
      const auto result = culled_rightly(clusters, draw, view.viewport, counts);
      if (!result) RC_FAIL(std::string(result.message()));
    }
  }));
  // Each answer was given often enough to have been put to the test.
  for (const ClusterView view :
       {ClusterView::outside, ClusterView::back_facing, ClusterView::inside, ClusterView::crossing})
    EXPECT_GT(counts[view], 1000) << int(view);
}

// Triangles much smaller than a pixel, within a few 1/256 pixel or a few roundings of the sides of
// the picture, of the guard band, and of near and far.
TEST(ClusterCulling, KnowsHowVerticesAreRoundedAtTheEdgesOfTheView) {
  std::mt19937_64 random(20240229);
  std::uniform_real_distribution<float> unit(-1, 1);
  const Viewport viewport{640, 640};
  const Camera camera = eye_at_origin(0.5, 50);
  Counts counts;
  for (int i = 0; i < 60000; ++i) {
    const float w = std::abs(unit(random)) * 40 + 1, inside = unit(random) * 0.9f;
    const float pixels = std::array{0.01f, 0.1f, 1.0f}[random() % 3] * unit(random);
    const float edge = std::array{1.0f, viewport.guard_x()}[random() % 2] + pixels / 320;
    const float rounding = 1 + std::array{1e-7f, 1e-6f, 1e-5f}[random() % 3] * unit(random);
    const glm::vec3 places[] = {
        {edge * w, inside * w, -w},           {-edge * w, inside * w, -w},
        {inside * w, edge * w, -w},           {inside * w, -edge * w, -w},
        {inside * 0.5f, 0, -0.5f * rounding}, {0, inside * 50, -50 * rounding}};
    const glm::vec3 place = places[random() % 6];
    const glm::vec3 origin = std::array{0.0f, 10.0f, 1000.0f}[random() % 3] *
                             glm::vec3(unit(random), unit(random), unit(random));
    std::vector<glm::vec3> corners(3, place + origin);
    for (glm::vec3& corner : corners)
      corner += 1e-6f * w * glm::vec3(unit(random), unit(random), unit(random));
    const auto mesh = triangle_soup(corners);
    const Draw draw = draw_of(*mesh, glm::translate(glm::mat4(1), -origin), camera, viewport);
    ASSERT_TRUE(culled_rightly(make_clusters(*mesh), draw, viewport, counts));
  }
  for (const ClusterView view : {ClusterView::outside, ClusterView::inside, ClusterView::crossing})
    EXPECT_GT(counts[view], 5000) << int(view);
}

/// A unit sphere that fills the height of a picture of so many pixels.
View view_of_sphere(int pixels, const glm::dvec3& direction) {
  View view{.camera = {}, .viewport = {pixels, pixels}, .world_from_object = glm::mat4(1)};
  view.camera.eye = 4.0 * glm::normalize(direction);
  view.camera.up = {0.1, 1, 0.2};
  view.camera.fov_deg = 29;
  return view;
}

TEST(ClusterCulling, DropsTheFarSideOfASphere) {
  const Mesh mesh = make_shape("sphere:100");
  const MeshClusters clusters = make_clusters(mesh);
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const float mirror : {1.0f, -1.0f}) {
      View view = view_of_sphere(1000, {1, 2, 3});
      view.camera.projection = projection;
      view.camera.far = 8;
      view.world_from_object = glm::scale(glm::mat4(1), glm::vec3(1, 1, mirror));
      const Draw draw = draw_of(mesh, view.world_from_object, view.camera, view.viewport);
      Counts counts;
      EXPECT_TRUE(culled_rightly(clusters, draw, view.viewport, counts));
      EXPECT_GT(counts[ClusterView::back_facing], 0.35 * double(clusters.clusters.size()));
      EXPECT_EQ(counts[ClusterView::outside], 0);
      EXPECT_EQ(counts[ClusterView::crossing], 0);

      Draw both_sides = draw;
      both_sides.draw_back_faces = true;
      Counts all;
      EXPECT_TRUE(culled_rightly(clusters, both_sides, view.viewport, all));
      EXPECT_EQ(all[ClusterView::inside], int(clusters.clusters.size()));
    }
}

// Where 128 triangles bend too far for a view to show only their backs, clusters are smaller.
TEST(ClusterCulling, DropsTheFarSideOfACoarseSphere) {
  const Mesh mesh = make_shape("sphere:22");
  const MeshClusters clusters = make_clusters(mesh);
  Counts counts;
  for (const glm::dvec3& direction : {glm::dvec3(1, 2, 3), {3, 0.1, 0.2}, {0, 1, 0.01}}) {
    const View view = view_of_sphere(1000, direction);
    const Draw draw = draw_of(mesh, view.world_from_object, view.camera, view.viewport);
    EXPECT_TRUE(culled_rightly(clusters, draw, view.viewport, counts));
  }
  EXPECT_GT(counts[ClusterView::back_facing], 0.25 * 3 * double(clusters.clusters.size()));
}

// Triangles of a third of a pixel and less, which snapping to 1/256 pixel turns over near the
// silhouette, though in exact arithmetic all of their cluster face away.
TEST(ClusterCulling, KnowsThatSnappingTurnsSmallTrianglesOver) {
  const Mesh mesh = make_shape("sphere:300");
  const MeshClusters clusters = make_clusters(mesh);
  for (const int pixels : {10, 30, 60, 200})
    for (const glm::dvec3& direction : {glm::dvec3(1, 2, 3), {3, 0.1, 0.2}, {0, 1, 0.01}}) {
      const View view = view_of_sphere(pixels, direction);
      const Draw draw = draw_of(mesh, view.world_from_object, view.camera, view.viewport);
      Counts counts;
      EXPECT_TRUE(culled_rightly(clusters, draw, view.viewport, counts)) << pixels << " pixels";
    }
}

// The eye is between two parallel triangles of one cluster, lower than its centre: from there the
// lower one faces the viewer, which the normals and the centre alone do not tell.
TEST(ClusterCulling, FacingAwayIsDecidedForEveryTriangleOfACluster) {
  const auto mesh = triangle_soup({{-1, -1, -1},
                                   {1, -1, -1},
                                   {0, 1, -1},  //
                                   {-1, -1, 1},
                                   {1, -1, 1},
                                   {0, 1, 1}});
  const MeshClusters clusters = make_clusters(*mesh);
  ASSERT_EQ(clusters.clusters.size(), 1u);
  const Viewport viewport{1000, 1000};
  Camera camera;
  camera.target = {0, 0, 0};
  camera.up = {0, 0, 1};
  const auto view_from = [&](double height) {
    camera.eye = {10, 0, height};
    return ClusterCuller(draw_of(*mesh, glm::mat4(1), camera, viewport), viewport)
        .view(clusters.clusters[0]);
  };
  EXPECT_EQ(view_from(-0.5), ClusterView::inside);
  EXPECT_EQ(view_from(-2), ClusterView::back_facing);
}

}  // namespace
}  // namespace scanlit
