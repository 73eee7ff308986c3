// A3.6: things that pass through each other, and one that lies on another.
#include <algorithm>
#include <glm/ext/matrix_transform.hpp>

#include "lessons/assignments/A3_visibility/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "models/registry.h"
#include "rasterizer/shapes.h"
#include "rasterizer/stages.h"

namespace scanlit::assignments::visibility {
namespace {

constexpr int width = 160, height = 120;

Scene crowded_scene() {
  Scene scene;
  const auto add = [&](const char* shape, const glm::mat4& place, const char* model) {
    Object& object = scene.objects.emplace_back();
    object.mesh = std::make_shared<const Mesh>(make_shape(shape));
    object.world_from_object = place;
    object.material.model = models::make(model).model;
    object.shading = Shading::flat;
    object.sides = Sides::both;
  };
  const glm::mat4 one(1);
  add("torus:18", glm::rotate(one, 1.1f, {1, 0.3f, 0}), "lambert:kd=.7/.45/.15");
  add("cube", glm::rotate(glm::scale(one, glm::vec3(0.55f)), 0.8f, {1, 2, 0.5f}),
      "lambert:kd=.2/.45/.7");
  // Of one shape in one place: which is seen, the rule for equal depths says.
  const glm::mat4 beside = glm::rotate(
      glm::translate(glm::scale(one, glm::vec3(0.33f)), {3.1f, -0.8f, 2.2f}), 0.7f, {0, 1, 0.2f});
  add("cube", beside, "lambert:kd=.7/.2/.2");
  add("cube", beside, "lambert:kd=.3/.65/.3");
  scene.lights.emplace_back().direction = {-2, 4, 3};
  scene.background = {0.02, 0.03, 0.06};
  return scene;
}

Camera crowded_camera() {
  Camera camera;
  camera.eye = {0.8, 1.9, 3.6};
  camera.fov_deg = 38;
  camera.near = 1, camera.far = 12;
  return camera;
}

/// Stored depths of a row of fragments; the corners' `depth` is their distance.
using StoreBy = std::function<std::vector<std::int64_t>(const Corner (&triangle)[3], int column,
                                                        int row, std::size_t count)>;
/// Whether each of a row of fragments is seen.
using TestBy = std::function<std::vector<std::int64_t>(const std::vector<StoredDepth>& fresh,
                                                       const std::vector<StoredDepth>& there)>;

Framebuffer picture_by(const DepthVariant& variant, const StoreBy& store_by,
                       const TestBy& test_by) {
  StageFunctions stages;
  // In the engine's buffer 0 is nothing, and any other number a stored depth plus 1.
  stages.depth = [&](const ScreenTriangle& t, int x, int y, std::span<float> depth) {
    Corner corners[3];
    for (int k = 0; k < 3; ++k) {
      const ScreenVertex& v = t.vertices[k];
      corners[k] = {v.x / double(subpixel), v.y / double(subpixel), 1 / double(v.inv_w)};
    }
    const auto stored = store_by(corners, x, y, depth.size());
    for (std::size_t i = 0; i < depth.size(); ++i)
      depth[i] = float(1 + std::clamp(stored[i], std::int64_t(0), std::int64_t(1 << 22)));
  };
  stages.depth_test = [&](std::span<const float> depth, std::span<const float> there,
                          std::span<std::uint8_t> seen) {
    std::vector<StoredDepth> fresh, old;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      fresh.push_back(StoredDepth(depth[i]) - 1);
      old.push_back(there[i] == 0 ? right_farthest(variant) : StoredDepth(there[i]) - 1);
    }
    const auto passes = test_by(fresh, old);
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = passes[i] != 0;
  };
  RenderSettings settings;
  settings.stages = &stages;
  Framebuffer framebuffer(width, height, {.ids = true});
  render(crowded_scene(), crowded_camera(), settings, framebuffer);
  return framebuffer;
}

std::string seen_at(const Framebuffer& picture, std::size_t pixel) {
  static constexpr const char* names[] = {"the torus", "the blue cube", "the red cube",
                                          "the green cube"};
  return picture.object_id[pixel] == no_id
             ? "the background"
             : names[picture.object_id[pixel]] + std::string(", triangle ") +
                   std::to_string(picture.triangle_id[pixel]);
}

}  // namespace

Framebuffer right_picture(const DepthVariant& variant) {
  const Camera camera = crowded_camera();
  return picture_by(
      variant,
      [&](const Corner(&triangle)[3], int column, int row, std::size_t count) {
        Corner corners[3];
        for (int k = 0; k < 3; ++k)
          corners[k] = {triangle[k].x, triangle[k].y,
                        right_depth_of(variant, triangle[k].depth, camera.near, camera.far)};
        std::vector<std::int64_t> stored;
        for (std::size_t i = 0; i < count; ++i)
          stored.push_back(
              right_stored(variant, right_depth_at(corners, column + double(i) + 0.5, row + 0.5)));
        return stored;
      },
      [&](const std::vector<StoredDepth>& fresh, const std::vector<StoredDepth>& there) {
        std::vector<std::int64_t> passes;
        for (std::size_t i = 0; i < fresh.size(); ++i)
          passes.push_back(right_replaces(variant, fresh[i], there[i]));
        return passes;
      });
}

Framebuffer starter_picture() {
  return picture_by(
      {.smaller_is_nearer = true, .bits = 8, .rounds = true, .last_wins = true},
      [](const Corner(&)[3], int, int, std::size_t count) {
        return std::vector<std::int64_t>(count, 0);
      },
      [](const std::vector<StoredDepth>& fresh, const std::vector<StoredDepth>&) {
        return std::vector<std::int64_t>(fresh.size(), 1);
      });
}

Finding test_picture(Examination& e) {
  const DepthVariant variant = depth_variant(e.variant);
  const Camera camera = crowded_camera();
  const Framebuffer fresh = picture_by(
      variant,
      [&](const Corner(&triangle)[3], int column, int row, std::size_t count) {
        Numbers question{.integers = {column, row, std::int64_t(count)},
                         .reals = {camera.near, camera.far}};
        for (const Corner& corner : triangle)
          question.reals.insert(question.reals.end(), {corner.x, corner.y, corner.depth});
        return e.student.ask(ask_depth_span, question, AnswerSize::integers(count)).integers;
      },
      [&](const std::vector<StoredDepth>& depth, const std::vector<StoredDepth>& there) {
        Numbers question;
        for (std::size_t i = 0; i < depth.size(); ++i)
          question.integers.insert(question.integers.end(), {depth[i], there[i]});
        return e.student.ask(ask_test_span, question, AnswerSize::integers(depth.size())).integers;
      });
  const Framebuffer reference = right_picture(variant);
  e.pictures.push_back(judged("A3.6-visible", "What is seen, by your depths", fresh, reference));
  const auto off = first_difference(e.pictures.back(), 1);
  // Rounding errors may put a depth on the other side of a step.
  constexpr int tolerated = 20;
  if (!off || off->count <= tolerated) return {};
  const auto pixel = std::size_t(off->y * width + off->x);
  return Finding::wrong(std::to_string(off->count) + " pixels differ, first that at column " +
                        std::to_string(off->x) + ", row " + std::to_string(off->y) +
                        ":\n  yours:     " + seen_at(fresh, pixel) +
                        "\n  should be: " + seen_at(reference, pixel));
}

}  // namespace scanlit::assignments::visibility
