// What the tests of exactness share: exact arithmetic, screens in whole numbers, scenes on them.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <vector>

#include "rasterizer/formula_model.h"
#include "rasterizer/pipeline.h"

namespace scanlit::test {

/// A property, checked for `cases` inputs that are the same in every run.
template <class Property>
testing::AssertionResult holds(int cases, Property&& property) {
  rc::detail::TestParams params;
  params.seed = 20240229;
  params.maxSuccess = cases;
  const auto result = rc::detail::checkTestable(std::forward<Property>(property),
                                                rc::detail::TestMetadata{}, params);
  if (result.template is<rc::detail::SuccessResult>()) return testing::AssertionSuccess();
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  return testing::AssertionFailure() << message.str();
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// ------------------------------------------------------------------------------ exact coverage

__extension__ typedef __int128 Exact;

/// Twice the signed area of (a, b, p), in 128 bits: nothing a 32-bit position holds overflows it.
inline Exact exact_edge(const ScreenVertex& a, const ScreenVertex& b, Exact px, Exact py) {
  return (Exact(b.x) - a.x) * (py - a.y) - (Exact(b.y) - a.y) * (px - a.x);
}

inline int exact_sign(const ScreenTriangle& t) {
  const auto& v = t.vertices;
  const Exact area = exact_edge(v[0], v[1], v[2].x, v[2].y);
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Whether the triangle covers the point (px, py), in 1/256 pixel. The top-left rule, stated apart
/// from the engine: a point on an edge belongs to the triangle that holds the point moved to the
/// right by an infinitely small step, and down by an infinitely smaller one.
inline bool exactly_covers(const ScreenTriangle& t, Exact px, Exact py) {
  const int orientation = exact_sign(t);
  if (orientation == 0) return false;
  for (int i = 0; i < 3; ++i) {
    const ScreenVertex &a = t.vertices[i], &b = t.vertices[(i + 1) % 3];
    Exact side = exact_edge(a, b, px, py);
    if (side == 0) side = Exact(a.y) - b.y;  // its change to the right
    if (side == 0) side = Exact(b.x) - a.x;  // its change downwards
    if (side * orientation <= 0) return false;
  }
  return true;
}

// --------------------------------------------------------------------------- triangles on a screen

inline ScreenVertex at_pixel(double x, double y, float depth = 0.5f, float inv_w = 1) {
  return {std::int32_t(x * subpixel), std::int32_t(y * subpixel), depth, inv_w};
}

/// Stage (7) alone, over any screen triangles: pixels `rect` of a picture.
inline VisibilityTile scan(const std::vector<ScreenTriangle>& triangles, const Rect& rect,
                           int samples = 1) {
  std::vector<DrawnTriangle> records;
  for (const ScreenTriangle& t : triangles)
    records.push_back({{t.vertices[0], t.vertices[1], t.vertices[2]},
                       0,
                       std::uint32_t(records.size()),
                       0,
                       DrawnTriangle::not_cut});
  VisibilityTile tile;
  tile.reset(rect, rect, samples);
  for (const DrawnTriangle& record : records) tile.triangles.push_back(&record);
  for (TriangleId id = 0; id < TriangleId(records.size()); ++id)
    if (triangles[id].twice_area != 0) scan_convert(id, tile, nullptr);
  return tile;
}

/// Index of the triangle that a sample sees, in the list given to scan(); -1 if none.
inline int seen(const VisibilityTile& tile, int x, int y, int sample = 0) {
  const TriangleId id = tile.triangle[tile.row(sample, y) + std::size_t(x - tile.rect.x_begin)];
  return id == no_triangle ? -1 : int(id);
}

inline float depth_of(const VisibilityTile& tile, int x, int y, int sample = 0) {
  return tile.depth[tile.row(sample, y) + std::size_t(x - tile.rect.x_begin)];
}

// ---------------------------------------------------------------------------------------- scenes

/// Orthographic; world (x, -y, z) is the screen position (x, y) in pixels at depth z. Without any
/// rounding if both sides are powers of two and x, y are multiples of 1/256.
inline Camera pixel_camera(int width, int height) {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.eye = {width / 2.0, -height / 2.0, 2};
  camera.target = {width / 2.0, -height / 2.0, 0};
  camera.height = height;
  camera.near = 1;
  camera.far = 2;
  return camera;
}

/// Looks along -z with a field of view of 90 degrees: at distance w a square picture reaches from
/// -w to w.
inline Camera eye_at_origin(double near = 0.1, double far = infinity) {
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  camera.fov_deg = 90;
  camera.near = near;
  camera.far = far;
  return camera;
}

/// A position that is often where clipping is delicate: behind the eye, in its plane, at it, on the
/// near plane, at the side of the guard band, or very far away.
inline glm::vec3 delicate_position(std::mt19937_64& random, const Viewport& viewport, float near) {
  std::uniform_real_distribution<float> unit(-1, 1);
  std::uniform_int_distribution<int> kind(0, 7);
  const float aspect = float(viewport.width) / float(viewport.height);
  glm::vec3 p(5 * unit(random), 5 * unit(random), 5 * unit(random));
  switch (kind(random)) {
    case 0: p.z = 0; break;
    case 1: p = {0, 0, 0}; break;
    case 2: p.z = -near; break;
    case 3: p *= 1e5f; break;
    case 4:
    case 5:
      p.z = -std::abs(p.z);
      p.x = viewport.guard_x() * p.z * aspect * (unit(random) > 0 ? 1 : -1);
      for (int i = std::uniform_int_distribution<int>(0, 2)(random); i > 0; --i)
        p.x = std::nextafter(p.x, unit(random) > 0 ? 1e30f : -1e30f);
      break;
    default: p.z = -std::abs(p.z);
  }
  return p;
}

/// Three corners a triangle, no vertex shared; normals point along +z, texcoords are (0,0).
inline std::shared_ptr<Mesh> triangle_soup(const std::vector<glm::vec3>& corners) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = corners;
  mesh->normals.assign(corners.size(), {0, 0, 1});
  mesh->texcoords.assign(corners.size(), {0, 0});
  for (std::uint32_t i = 0; i < corners.size(); ++i) mesh->indices.push_back(i);
  return mesh;
}

/// Corners given as on the screen (y down) for pixel_camera.
inline std::vector<glm::vec3> on_screen(std::vector<glm::vec3> corners) {
  for (glm::vec3& corner : corners) corner.y = -corner.y;
  return corners;
}

/// Reflects 1 whatever the directions.
struct White {
  template <class T>
  Reflection<T> operator()(const Cosines<T>&) const {
    return {.diffuse = Rgb<T>(T(1)), .glossy = {}};
  }
};

/// Reflects N.L.
struct CosineOnly {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = Rgb<T>(c.n_l), .glossy = {}};
  }
};

/// Reflects the surface point: object position as the diffuse part, texcoord as the glossy one.
struct ShowPoint {
  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const SurfacePoint<T>& p) const {
    return {.diffuse = {p.object_position.x, p.object_position.y, p.object_position.z},
            .glossy = {p.u, p.v, T(0)}};
  }
};

/// An object of no ambient reflectance, seen from both sides.
template <class Formula = White>
Object object_of(std::shared_ptr<const Mesh> mesh, Formula formula = {},
                 Shading shading = Shading::phong) {
  Object object;
  object.mesh = std::move(mesh);
  object.material.model = std::make_shared<FormulaModel<Formula>>(formula);
  object.material.ka = Rgb<double>(0);
  object.shading = shading;
  object.sides = Sides::both;
  return object;
}

/// One directional light of intensity 1 along +z, and no ambient light.
inline Scene scene_of(std::vector<Object> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.lights.emplace_back();
  scene.ambient = Rgb<double>(0);
  return scene;
}

struct Picture {
  Framebuffer framebuffer;
  FrameStats stats;

  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(framebuffer.width) + std::size_t(x);
  }
  const float* colour(int x, int y) const { return &framebuffer.colour[4 * index(x, y)]; }
  std::uint32_t triangle(int x, int y) const { return framebuffer.triangle_id[index(x, y)]; }
};

inline RenderSettings with_samples(int samples) {
  RenderSettings settings;
  settings.samples = samples;
  return settings;
}

inline Picture picture_of(const Scene& scene, const Camera& camera, int width, int height,
                          const RenderSettings& settings = {}) {
  Picture picture{
      Framebuffer(width, height, {.depth = true, .normal = true, .ids = true, .parts = true}), {}};
  picture.stats = render(scene, camera, settings, picture.framebuffer);
  return picture;
}

}  // namespace scanlit::test
