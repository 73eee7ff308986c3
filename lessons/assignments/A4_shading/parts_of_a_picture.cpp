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
      const double length = (1.0 + v % 3) * (piece.back_facing ? -1 : 1);
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

Colour right_colour(const ShadingVariant& variant, Interpolated what, const Vertex (&triangle)[3],
                    const Weights& w, const Scene& scene) {
  const auto& [a, b, c] = triangle;
  const auto lit = [&](const Vertex& v) { return right_vertex(variant, v, scene); };
  if (what == Interpolated::normals) return right_fragment(variant, triangle, w, scene);
  if (what == Interpolated::colours) return right_between({lit(a), lit(b), lit(c)}, w);
  return 0.5 * (unit(a.normal) + Vector{1, 1, 1});
}

/// A fragment of the wrong colour.
struct Fault {
  Vertex triangle[3];
  Weights weights;
};

/// Both ways to it, step by step: the student's functions on the right results of the step before.
std::string derive(Examination& e, const Fault& fault, Interpolated what, const Scene& scene) {
  const ShadingVariant variant = shading_variant(e.variant);
  const auto step = [&](const char* name, int kind, const Numbers& question, Vector right) {
    return std::string("\n    ") + name +
           yours_and_right("  yours ", ask(e, kind, question), ", should be ", right);
  };
  const auto light_at = [&](Vector normal, Vector position) {
    const Vector to_viewer = unit(scene.eye - position);
    Numbers question;
    put(normal, question), put(to_viewer, question), put(scene, question);
    return step("light:   ", ask_light, question, right_light(variant, normal, to_viewer, scene));
  };
  const auto& [a, b, c] = fault.triangle;
  std::string text =
      "\n  one such fragment, with weights " +
      words(Vector{fault.weights.corner[0], fault.weights.corner[1], fault.weights.corner[2]}) +
      ", step by step, each given\n  what is right of the steps before";
  Numbers between;
  if (what == Interpolated::normals) {
    for (const Vertex& v : fault.triangle) put(v.normal, between);
    put(fault.weights, between);
    const Vector normal = right_normal(variant, {a.normal, b.normal, c.normal}, fault.weights);
    Numbers fragment;
    for (const Vertex& v : fault.triangle) put(v, fragment);
    put(fault.weights, fragment), put(scene, fragment);
    return text + ":" + step("normal:  ", ask_normal, between, normal) +
           light_at(normal, right_between({a.position, b.position, c.position}, fault.weights)) +
           step("fragment:", ask_fragment, fragment,
                right_fragment(variant, fault.triangle, fault.weights, scene));
  }
  Vector corners[3];
  for (int k = 0; k < 3; ++k) {
    corners[k] = right_vertex(variant, fault.triangle[k], scene);
    put(corners[k], between);
  }
  put(fault.weights, between);
  Numbers vertex;
  put(a, vertex), put(scene, vertex);
  return text +
         " (light and vertex: those of the first corner):" + light_at(unit(a.normal), a.position) +
         step("vertex:  ", ask_vertex, vertex, corners[0]) +
         step("between: ", ask_interpolate, between, right_between(corners, fault.weights));
}

Finding test_shading(Examination& e, int kind, Interpolated what, const std::string& name) {
  const ShadingVariant variant = shading_variant(e.variant);
  const Stage stage = teapot_stage();
  std::vector<Fault> faults;  // the first one
  const Framebuffer fresh =
      teapot(stage, [&](const Vertex(&triangle)[3], const std::vector<Weights>& weights) {
        Numbers question;
        for (const Vertex& vertex : triangle) put(vertex, question);
        put(stage.shaded, question);
        question.integers.push_back(std::int64_t(weights.size()));
        for (const Weights& w : weights) put(w, question);
        const auto size = AnswerSize::reals(3 * weights.size());
        const std::vector<double> r = e.student.ask(kind, question, size).reals;
        std::vector<Colour> colours;
        for (std::size_t i = 0; i < weights.size(); ++i) {
          colours.push_back({r[3 * i], r[3 * i + 1], r[3 * i + 2]});
          const Vector off =
              colours[i] - right_colour(variant, what, triangle, weights[i], stage.shaded);
          if (faults.empty() && dot(off, off) > 1e-4)
            faults.push_back({{triangle[0], triangle[1], triangle[2]}, weights[i]});
        }
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
                        yours_and_right(":\n  yours:     ", colour_at(fresh, off->x, off->y),
                                        "\n  should be: ", colour_at(reference, off->x, off->y)) +
                        (faults.empty() ? "" : derive(e, faults[0], what, stage.shaded)));
}

}  // namespace

Framebuffer right_teapot(const ShadingVariant& variant, Interpolated what) {
  const Stage stage = teapot_stage();
  return teapot(stage, [&](const Vertex(&triangle)[3], const std::vector<Weights>& weights) {
    std::vector<Colour> colours;
    for (const Weights& w : weights)
      colours.push_back(right_colour(variant, what, triangle, w, stage.shaded));
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
