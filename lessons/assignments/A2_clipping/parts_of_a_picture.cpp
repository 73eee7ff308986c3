// A2.6: a chequered floor that reaches from behind the eye to the horizon, and a flag on it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lessons/assignments/A2_clipping/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "models/registry.h"
#include "rasterizer/stages.h"

namespace scanlit::assignments::clipping {
namespace {

constexpr int width = 160, height = 120;

/// Cells of 4 x 4 squares, of which those at the eye reach behind it; a flag, the last triangle.
Scene floor_scene() {
  auto mesh = std::make_shared<Mesh>();
  constexpr std::uint32_t columns = 3, rows = 5;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) {
      mesh->positions.push_back({-6 + 4 * float(i), 0, 8 - 4 * float(j)});
      mesh->texcoords.push_back({4 * float(i), 4 * float(j)});
      if (i == columns || j == rows) continue;
      const std::uint32_t v = j * (columns + 1) + i, below = v + columns + 1;
      mesh->indices.insert(mesh->indices.end(), {v, v + 1, below + 1, v, below + 1, below});
    }
  const auto flag = std::uint32_t(mesh->positions.size());
  mesh->positions.insert(mesh->positions.end(),
                         {{-0.5f, 0, -1}, {1.8f, 0.4f, 3}, {-0.2f, 1.5f, -1}});
  mesh->texcoords.insert(mesh->texcoords.end(), {{0.5f, 0.5f}, {4.5f, 0.5f}, {0.5f, 3.5f}});
  mesh->indices.insert(mesh->indices.end(), {flag, flag + 1, flag + 2});
  mesh->normals.assign(mesh->positions.size(), {0, 1, 0});
  Scene scene;
  Object& floor = scene.objects.emplace_back();
  floor.mesh = mesh;
  floor.material.model = models::make("lambert").model;
  scene.background = {0.05, 0.08, 0.15};
  return scene;
}

bool is_flag(const Mesh& mesh, std::uint32_t triangle) {
  return triangle + 1 == mesh.triangle_count();
}

Camera floor_camera() {
  Camera camera;
  camera.eye = {0, 0.9, 2};
  camera.target = {0, 0.4, -2};
  camera.fov_deg = 70;
  camera.near = 0.5, camera.far = 11;
  return camera;
}

// The engine's depth is reversed: 1 at near, 0 at far.
Vertex in_variant(const ClipVariant& variant, const ClipVertex& v, int corner) {
  const double z = double(v.z), w = double(v.w);
  Vertex turned{double(v.x), double(v.y), variant.near_at_0 ? w - z : w - 2 * z, w, {}};
  turned.attribute[corner] = 1;
  return turned;
}
ClipVertex in_engine(const ClipVariant& variant, const Vertex& v) {
  return {float(v.x), float(v.y), float(variant.near_at_0 ? v.w - v.z : (v.w - v.z) / 2),
          float(v.w)};
}

/// What the engine can go on with, in whole numbers (Viewport).
bool on_the_screen(const ClipVertex& v, const Viewport& viewport) {
  return v.w > 1e-6f && std::abs(v.x) <= viewport.guard_x() * v.w &&
         std::abs(v.y) <= viewport.guard_y() * v.w && v.z >= -1e-4f * v.w && v.z <= 1.0001f * v.w;
}

void append_fan(const ClipVariant& variant, const Polygon& polygon, const Viewport& viewport,
                std::vector<ClippedTriangle>& pieces, bool& all_there) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vertex corners[3] = {polygon[0], polygon[i - 1], polygon[i]};
    ClippedTriangle piece;
    bool good = true;
    for (int k = 0; k < 3; ++k) {
      const ClipVertex v = in_engine(variant, corners[k]);
      good = good && on_the_screen(v, viewport);
      if (!good) break;
      piece.vertices[k] = project(v, viewport);
      for (int c = 0; c < 3; ++c)
        piece.barycentric[k][c] = float(std::clamp(corners[k].attribute[c], -100.0, 100.0));
    }
    if (good) pieces.push_back(piece);
    all_there = all_there && good;
  }
}

using ClipBy = std::function<Polygon(const Vertex (&triangle)[3])>;
/// Weights of a row of fragments, and w of the corners.
using WeightsBy = std::function<std::vector<Weights>(const std::vector<Weights>& on_screen,
                                                     const double (&w)[3])>;

std::vector<Weights> weights_on_screen(const ScreenTriangle& t, int x, int y, std::size_t count) {
  std::vector<Weights> all;
  const std::int64_t py = y * subpixel + half_pixel;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t px = (x + int(i)) * subpixel + half_pixel;
    Weights weights;
    for (int k = 0; k < 3; ++k)
      weights.corner[k] =
          double(edge_function(t.vertices[(k + 1) % 3], t.vertices[(k + 2) % 3], px, py)) /
          double(t.twice_area);
    all.push_back(weights);
  }
  return all;
}

/// Dark and light squares; the flag's are red.
Rgb<float> chequer(const Mesh& mesh, std::uint32_t triangle, float b1, float b2) {
  const std::uint32_t* const v = &mesh.indices[3 * std::size_t(triangle)];
  const glm::vec2 at =
      (1 - b1 - b2) * mesh.texcoords[v[0]] + b1 * mesh.texcoords[v[1]] + b2 * mesh.texcoords[v[2]];
  const bool light = (int(std::floor(at.x)) + int(std::floor(at.y))) & 1;
  if (is_flag(mesh, triangle))
    return light ? Rgb<float>{0.8f, 0.5f, 0.4f} : Rgb<float>{0.5f, 0.08f, 0.06f};
  return light ? Rgb<float>{0.7f, 0.7f, 0.65f} : Rgb<float>{0.1f, 0.12f, 0.1f};
}

Framebuffer floor_by(const ClipVariant& variant, const ClipBy& clip_by, const WeightsBy& weights_by,
                     bool& all_there) {
  StageFunctions stages;
  stages.clip = [&](const ClipVertex(&t)[3], const Viewport& viewport,
                    std::vector<ClippedTriangle>& pieces) {
    const Vertex triangle[3] = {in_variant(variant, t[0], 0), in_variant(variant, t[1], 1),
                                in_variant(variant, t[2], 2)};
    append_fan(variant, clip_by(triangle), viewport, pieces, all_there);
  };
  stages.barycentric = [&](const StagedPiece& piece, int x, int y, std::span<float> b1,
                           std::span<float> b2) {
    double w[3];
    for (int k = 0; k < 3; ++k) w[k] = 1 / double(piece.screen.vertices[k].inv_w);
    const auto weights = weights_by(weights_on_screen(piece.screen, x, y, b1.size()), w);
    for (std::size_t i = 0; i < b1.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const auto share = float(std::clamp(weights[i].corner[k], -1000.0, 1000.0));
        b1[i] += share * piece.corners.barycentric[k][1];
        b2[i] += share * piece.corners.barycentric[k][2];
      }
  };
  stages.shade = [](const StagedPiece& piece, std::span<const float> b1, std::span<const float> b2,
                    std::span<Rgb<float>> colour) {
    for (std::size_t i = 0; i < colour.size(); ++i)
      colour[i] = chequer(*piece.object->mesh, piece.triangle, b1[i], b2[i]);
  };
  RenderSettings settings;
  settings.stages = &stages;
  Framebuffer framebuffer(width, height, {.ids = true});
  render(floor_scene(), floor_camera(), settings, framebuffer);
  return framebuffer;
}

std::vector<Weights> right_weights(const std::vector<Weights>& on_screen, const double (&w)[3]) {
  std::vector<Weights> all;
  for (const Weights& each : on_screen) all.push_back(right_perspective(each, w));
  return all;
}

}  // namespace

Framebuffer right_floor(const ClipVariant& variant) {
  bool all_there = true;
  return floor_by(
      variant, [&](const Vertex(&t)[3]) { return right_pieces(variant, t); }, right_weights,
      all_there);
}

Framebuffer starter_floor() {
  bool all_there = true;
  const auto whole = [](const Vertex(&t)[3]) {
    const bool in_front = t[0].w > 0 && t[1].w > 0 && t[2].w > 0;
    return in_front ? Polygon(t, t + 3) : Polygon();
  };
  const auto affine = [](const std::vector<Weights>& w, const double(&)[3]) { return w; };
  return floor_by({}, whole, affine, all_there);
}

Finding test_picture(Examination& e) {
  const ClipVariant variant = clip_variant(e.variant);
  const auto clip_by = [&](const Vertex(&t)[3]) {
    Numbers question;
    for (const Vertex& v : t) put(v, question);
    return polygon_of(e.student.ask(ask_whole_triangle, question, {.most_reals = 7 * 64}));
  };
  const auto weights_by = [&](const std::vector<Weights>& on_screen, const double(&w)[3]) {
    Numbers question{.integers = {std::int64_t(on_screen.size())}, .reals = {}};
    for (const double each : w) question.reals.push_back(variant.given_inv_w ? 1 / each : each);
    for (const Weights& each : on_screen) put(each, question);
    const auto r =
        e.student.ask(ask_perspective_span, question, AnswerSize::reals(3 * on_screen.size()))
            .reals;
    std::vector<Weights> all;
    for (std::size_t i = 0; i < r.size(); i += 3) all.push_back({{r[i], r[i + 1], r[i + 2]}});
    return all;
  };
  bool all_there = true;
  const Framebuffer fresh = floor_by(variant, clip_by, weights_by, all_there);
  const Framebuffer reference = right_floor(variant);
  e.pictures.push_back(
      judged("A2.6-floor", "A floor and a flag, by your functions", fresh, reference));
  const auto off = first_difference(e.pictures.back(), 1);
  const std::string beyond =
      all_there ? "" : "\nSome pieces reach behind the eye or far beyond the window: not drawn.";
  // Rounding may move a square's border, or a cut vertex's 1/256 pixel.
  constexpr int tolerated = 20;
  if ((!off || off->count <= tolerated) && all_there) return {};
  if (!off) return Finding::wrong("The picture is right, but" + beyond.substr(1));
  const auto pixel = std::size_t(off->y * width + off->x);
  const auto seen = [&](const Framebuffer& f) -> std::string {
    const std::uint32_t triangle = f.triangle_id[pixel];
    return triangle == no_id                                   ? "the background"
           : is_flag(*floor_scene().objects[0].mesh, triangle) ? "the flag"
                                                               : "the floor";
  };
  return Finding::wrong(std::to_string(off->count) + " pixels differ, first that at column " +
                        std::to_string(off->x) + ", row " + std::to_string(off->y) +
                        ":\n  yours:     " + seen(fresh) + "\n  should be: " + seen(reference) +
                        (seen(fresh) == seen(reference) ? ", another square of it" : "") + beyond);
}

}  // namespace scanlit::assignments::clipping
