// New idea: an isotropic surface may be turned about its normal, and nobody sees it; a brushed not.
// Builds on: lesson 28, a BRDF as a function of two directions.
// Try: --across .1; --along .5; what happens where both are the same?
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <random>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/query.h"

using namespace scanlit;

// new idea
/// The surface turned about its normal, under light and viewer that stand still: in its own frame
/// it is they that turn, the other way round, and both by the same angle.
Vec3<double> turned(const Vec3<double>& d, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * d.x + s * d.y, c * d.y - s * d.x, d.z};
}

/// By how much of its larger value the model's reflection changes at most, tried out at 10000 pairs
/// of directions and angles. 0: isotropic.
double largest_change(const ReflectionModel& model) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> theta(0, 89), phi(0, 360);
  double largest = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto l = studio::direction_at(theta(random), phi(random));
    const auto v = studio::direction_at(theta(random), phi(random));
    const double angle = glm::radians(phi(random));
    const double before = studio::luminance(studio::reflected(model, l, v));
    const double after =
        studio::luminance(studio::reflected(model, turned(l, angle), turned(v, angle)));
    largest = std::max(largest, std::abs(after - before) / std::max({before, after, 1e-9}));
  }
  return largest;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Isotropic and brushed plates, turned under a fixed light.", 1740, 1160);
  double along = .07, across = .35;
  lesson.knob("--along", along, {.02, 1}, "how rough along the brush's strokes");
  lesson.knob("--across", across, {.02, 1}, "how rough across them");

  return lesson.run(argc, argv, [&] {
    for (const std::string model :
         {"blinn-phong", "cook-torrance", "oren-nayar", "ward", "ashikhmin-shirley"})
      lesson.figure("default " + model + " turned, largest change",
                    studio::fixed(100 * largest_change(*models::make(model).model), 1) + " %");
    const auto plate = [&](int panel, int width, int height) {
      const bool brushed = panel >= 3;
      const double even = std::sqrt(along * across);
      const std::string rough = "ax=" + studio::text_of(brushed ? along : even) +
                                ",ay=" + studio::text_of(brushed ? across : even);
      // The strokes as they are seen: noise, drawn out along the brush.
      Object object = studio::make_object(
          "plane:1",
          "ward:kd=wood-colour(early=.11,late=.045,streaks=1,ring=9,streak=.006,pith=90,"
          "wander=0),rho=.62/.64/.68," +
              rough);
      object.material.tangents = {.field = TangentField::along, .axis = {1, 0, 0}};
      const float angle = glm::radians(30.f * float(panel % 3));
      object.world_from_object = glm::rotate(glm::mat4(1), angle, {0, 0, 1});
      Scene scene = studio::make_stage({object});
      scene.lights = {Light{.kind = LightKind::point, .intensity = .1, .position = {0, .9, 1.6}}};
      const Camera still{.eye = {0, -1.5, 3}, .target = {0, -.23, 0}, .fov_deg = 45};
      return studio::photograph(scene, still, width, height);
    };
    return studio::panels(
        lesson.width(), lesson.height(), 3,
        {"isotropic", "turned by 30 degrees", "by 60", "brushed", "turned by 30 degrees", "by 60"},
        plate);
  });
}
