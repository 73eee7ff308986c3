#include "lessons/studio/tradeoff/study_scene.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lessons/studio/description.h"

namespace scanlit::studio {
namespace {

constexpr double aspect = double(study_width) / study_height;

Description describe(const std::string& shape, const std::string& model) {
  Description description = describe_object(shape);
  MaterialDescription& material = description.objects[0].material;
  material.model = models::make(model);
  material.ka = Rgb<double>(0.06);  // the same for all models
  return description;
}

}  // namespace

StudyScene study_scene(const std::string& shape, const std::string& model) {
  const Description description = describe(shape, model);
  const std::string any_size = shape.substr(0, shape.find(':')) + ":32";
  const Scene framed = make_scene(describe(any_size, model));
  StudyScene study{make_scene(description), make_camera(description.view, framed, aspect)};
  study.scene.lights = make_lights(description, study.camera);
  return study;
}

StudyScene wall_scene() {
  StudyScene study{make_scene(describe("plane:1", study_model)), {}};
  const glm::mat4 turned = glm::rotate(glm::mat4(1), glm::radians(68.0f), {0, 1, 0});
  study.scene.objects[0].world_from_object = glm::scale(turned, glm::vec3(3));
  study.camera = {.eye = {0.9, 0.3, 4.6}, .target = {0.25, 0, 0}, .fov_deg = 50};
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.position = {1.1, 0.7, 0.3};
  lamp.constant = 0.3, lamp.quadratic = 0.5;
  study.scene.lights = {lamp};
  return study;
}

StudyScene lights_scene() {
  StudyScene study = study_scene("sphere:16");
  study.scene.lights.clear();
  for (int i = 0; i < 16; ++i) {
    const double azimuth = i * glm::two_pi<double>() / 16, height = .3 + .08 * (i % 5);
    study.scene.lights.push_back(
        {.intensity = .12, .direction = {std::cos(azimuth), height, .5 + std::sin(azimuth)}});
  }
  return study;
}

Candidate engine_candidate(std::shared_ptr<Renderer> renderer,
                           std::shared_ptr<const StudyScene> study, const std::string& series,
                           const std::string& label, RenderSettings settings) {
  settings.threads = 1;
  const auto draw = [=](Framebuffer& framebuffer) {
    renderer->render(study->scene, study->camera, settings, framebuffer);
  };
  const auto frame = std::make_shared<Framebuffer>(study_width, study_height);
  return {.series = series,
          .label = label,
          .triangles = std::int64_t(study->scene.objects[0].mesh->triangle_count()),
          .draw = [=] { draw(*frame); },
          .picture =
              [=] {
                Framebuffer with_ids(study_width, study_height, {.ids = true});
                draw(with_ids);
                return exact_picture(with_ids);
              }};
}

ExactPicture reference_of(const StudyScene& study) {
  return render_reference(study.scene, study.camera, study_width, study_height);
}

}  // namespace scanlit::studio
