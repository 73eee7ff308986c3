// A4.6: a teapot in Gouraud and in Phong shading.
#include <algorithm>
#include <glm/geometric.hpp>

#include "lessons/assignments/A4_shading/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "models/registry.h"
#include "rasterizer/shapes.h"
#include "rasterizer/stages.h"

namespace scanlit::assignments::shading {

namespace {

constexpr int width = 160, height = 120;

Vector from_glm(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

struct Stage {
  scanlit::Scene scene;
  Camera camera;
  Scene shaded;
};

/// The same to the engine, which finds what is seen, and to the student, who shades it.
Stage teapot_stage() {
  Stage stage;
  Object& teapot = stage.scene.objects.emplace_back();
  teapot.mesh = std::make_shared<const Mesh>(make_shape("teapot:2"));
  teapot.material.model = models::make("lambert").model;
  stage.scene.background = {0.02, 0.03, 0.06};
  stage.camera.eye = {1.5, 3, 6};
  stage.camera = framed(stage.camera, bounding_sphere(stage.scene), double(width) / height);
  stage.camera.fov_deg = 33;  // closer
  stage.shaded = {
      from_glm(stage.camera.eye),
      {{unit(Vector{1, 2, 3}), {0.9, 0.9, 0.85}}, {unit(Vector{-3, 1, 0.5}), {0.15, 0.2, 0.3}}},
      {0.03, 0.02, 0.015},
      {0.55, 0.35, 0.2},
      0.5,
      40};
  return stage;
}

/// Colours of a row of fragments.
using ShadeRow =
    std::function<std::vector<Colour>(const Vertex (&triangle)[3], const std::vector<Weights>&)>;

Framebuffer teapot(const Stage& stage, const ShadeRow& shade_row) {
  StageFunctions stages;
  stages.shade = [&](const StagedPiece& piece, std::span<const float> b1, std::span<const float> b2,
                     std::span<Rgb<float>> colour) {
    const Mesh& mesh = *piece.object->mesh;
    Vertex triangle[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.indices[3 * std::size_t(piece.triangle) + k];
      // Of lengths that differ, as they come from some files.
      const double length = (1 + v % 3) * (piece.back_facing ? -1 : 1);
      triangle[k] = {from_glm(mesh.positions[v]), length * from_glm(mesh.normals[v])};
    }
    std::vector<Weights> weights;
    for (std::size_t i = 0; i < b1.size(); ++i) {
      const double b = double(b1[i]), c = double(b2[i]);
      weights.push_back({{1 - b - c, b, c}});
    }
    const std::vector<Colour> colours = shade_row(triangle, weights);
    for (std::size_t i = 0; i < colour.size(); ++i)
      colour[i] = {float(colours[i].x), float(colours[i].y), float(colours[i].z)};
  };
  RenderSettings settings;
  settings.stages = &stages;
  Framebuffer framebuffer(width, height);
  render(stage.scene, stage.camera, settings, framebuffer);
  return framebuffer;
}

Colour colour_at(const Framebuffer& picture, int x, int y) {
  const float* const pixel = &picture.colour[4 * std::size_t(y * width + x)];
  return {pixel[0], pixel[1], pixel[2]};
}

/// A step of 8 bits may be crossed by rounding.
constexpr int tolerance = 1;

Finding test_shading(Examination& e, int kind, Interpolated what, const std::string& name) {
  const ShadingVariant variant = shading_variant(e.variant);
  const Stage stage = teapot_stage();
  const Framebuffer fresh =
      teapot(stage, [&](const Vertex(&triangle)[3], const std::vector<Weights>& weights) {
        Numbers question;
        for (const Vertex& vertex : triangle) put(vertex, question);
        put(stage.shaded, question);
        question.integers.push_back(std::int64_t(weights.size()));
        for (const Weights& w : weights)
          question.reals.insert(question.reals.end(), w.corner, w.corner + 3);
        const auto size = AnswerSize::reals(3 * weights.size());
        const std::vector<double> r = e.student.ask(kind, question, size).reals;
        std::vector<Colour> colours;
        for (std::size_t i = 0; i < r.size(); i += 3) colours.push_back({r[i], r[i + 1], r[i + 2]});
        return colours;
      });
  const Framebuffer reference = right_teapot(variant, what);
  e.pictures.push_back(
      judged("A4.6-" + name, "The teapot in " + name + " shading", fresh, reference));
  const auto off = first_difference(e.pictures.back(), tolerance);
  if (!off) return {};
  return Finding::wrong("In " + name + " shading " + std::to_string(off->count) +
                        " pixels differ, first that at column " + std::to_string(off->x) +
                        ", row " + std::to_string(off->y) +
                        ":\n  yours:     " + words(colour_at(fresh, off->x, off->y)) +
                        "\n  should be: " + words(colour_at(reference, off->x, off->y)));
}

}  // namespace

Framebuffer right_teapot(const ShadingVariant& variant, Interpolated what) {
  const Stage stage = teapot_stage();
  return teapot(stage, [&](const Vertex(&triangle)[3], const std::vector<Weights>& weights) {
    const auto& [a, b, c] = triangle;
    const auto lit = [&](const Vertex& v) { return right_vertex(variant, v, stage.shaded); };
    std::vector<Colour> colours;
    for (const Weights& w : weights)
      colours.push_back(what == Interpolated::normals
                            ? right_fragment(variant, triangle, w, stage.shaded)
                        : what == Interpolated::colours ? right_between({lit(a), lit(b), lit(c)}, w)
                                                        : 0.5 * (unit(a.normal) + Vector{1, 1, 1}));
    return colours;
  });
}

Finding test_pictures(Examination& e) {
  const Finding gouraud = test_shading(e, ask_gouraud_span, Interpolated::colours, "Gouraud");
  const Finding phong = test_shading(e, ask_phong_span, Interpolated::normals, "Phong");
  if (gouraud.share == 1 || phong.share == 1) return gouraud.share < 1 ? gouraud : phong;
  return Finding::wrong(gouraud.message + "\n" + phong.message);
}

}  // namespace scanlit::assignments::shading
