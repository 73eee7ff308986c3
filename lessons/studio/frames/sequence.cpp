#include "lessons/studio/frames/sequence.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "rasterizer/error.h"

namespace scanlit::studio {

const Choices<Orbit> orbits{{"none", Orbit::none},
                            {"camera", Orbit::camera},
                            {"object", Orbit::object},
                            {"light", Orbit::light}};

namespace {

/// Frames spread evenly from the first to the last: so many that between two of them a turned
/// object moves by less than the picture's margin.
std::vector<int> spread(int frames) {
  constexpr int most = 25;
  const int count = std::min(frames, most);
  std::vector<int> samples;
  for (int i = 0; i < count; ++i)
    samples.push_back(count == 1 ? 0 : int(std::int64_t(i) * (frames - 1) / (count - 1)));
  return samples;
}

glm::dvec3 turned_point(const glm::dmat4& turn, const glm::dvec3& point) {
  return glm::dvec3(turn * glm::dvec4(point, 1.0));
}

glm::dvec3 turned_direction(const glm::dmat4& turn, const glm::dvec3& direction) {
  return glm::dmat3(turn) * direction;
}

void turn_objects(Scene& scene, const glm::dmat4& turn) {
  for (Object& object : scene.objects)
    object.world_from_object = glm::mat4(turn * glm::dmat4(object.world_from_object));
}

}  // namespace

Sequence::Sequence(std::string input, std::vector<GivenEdit> edits, Motion motion)
    : input_(std::move(input)), edits_(std::move(edits)), motion_(std::move(motion)) {
  if (!motion_.sweeps.empty() && !is_scene(input_))
    throw Error("--sweep", "names a place in a scene file, which '" + input_ +
                               "' is not; sweep an option: --model phong:n=5:100");
  if (!motion_.sweeps.empty()) studio::describe(input_, {});  // its own faults, in its own words
  first_ = describe(0);
  describe(motion_.frames - 1);  // of what is out of range the end is named, and not the way there
  const std::vector<int> samples = spread(motion_.frames);
  for (const int index : samples) {
    const Description description = describe(index);
    if (description.picture.width != first_.picture.width ||
        description.picture.height != first_.picture.height)
      throw Error("--sweep", "the frames would differ in size");
    camera_swept_ |= description.view.azimuth_deg != first_.view.azimuth_deg ||
                     description.view.elevation_deg != first_.view.elevation_deg ||
                     description.view.up != first_.view.up;
  }
  find_bounds(samples);
  camera_ = camera_of(first_.view);
  for (const int index : samples) {
    const FrameScene checked = frame(index);
    validate(checked.scene);
  }
}

void Sequence::find_bounds(const std::vector<int>& samples) {
  const Scene scene = make_scene(first_, meshes_);
  centre_ = first_.view.target.value_or(bounding_sphere(scene).centre);
  axis_ = motion_.axis.value_or(first_.view.up);
  if (glm::length(axis_) == 0) throw Error("--axis", "the axis is the zero vector");
  const bool objects_move = motion_.orbit == Orbit::camera || motion_.orbit == Orbit::object ||
                            std::ranges::any_of(motion_.sweeps, [](const PathSweep& s) {
                              return s.path.starts_with("object.");
                            });
  if (!objects_move) {
    everywhere_ = scene;
    return;
  }
  for (const int index : samples) {
    Scene there = scene_of(describe(index), index);
    // A camera that goes one way around sees what one that stands sees of objects that go the
    // other.
    if (motion_.orbit == Orbit::camera) turn_objects(there, turn(index, -1));
    std::ranges::move(there.objects, std::back_inserter(everywhere_.objects));
  }
}

Description Sequence::describe(int index) const {
  const double share = motion_.frames > 1 ? double(index) / (motion_.frames - 1) : 0;
  std::vector<GivenEdit> edits = edits_;
  for (GivenEdit& given : edits) given.text = text_at(given.edit->option, given.text, share);
  if (motion_.sweeps.empty()) return studio::describe(input_, edits);
  std::vector<SceneChange> changes;
  for (const PathSweep& swept : motion_.sweeps)
    changes.push_back({swept.path, swept.sweep.at(share)});
  try {
    return studio::describe(input_, edits, changes);
  } catch (const Error& error) {
    throw Error("--sweep", error.what());
  }
}

glm::dmat4 Sequence::turn(int index, double direction) const {
  const double angle_rad = direction * glm::radians(360.0) * index / motion_.frames;
  const glm::dmat4 identity(1.0);
  return glm::translate(identity, centre_) * glm::rotate(identity, angle_rad, axis_) *
         glm::translate(identity, -centre_);
}

Scene Sequence::scene_of(const Description& description, int index) {
  Scene scene = make_scene(description, meshes_);
  if (motion_.orbit == Orbit::object) turn_objects(scene, turn(index, 1));
  // A swept crease makes a new mesh for every frame.
  std::erase_if(meshes_, [](const auto& mesh) { return mesh.second.use_count() == 1; });
  return scene;
}

/// Without an orbit.
Camera Sequence::camera_of(View view) const {
  // Fitted anew from every direction, the camera would come and go.
  if (camera_swept_ && !view.eye && !view.target) view.target = bounding_sphere(everywhere_).centre;
  const Picture& picture = first_.picture;
  return make_camera(view, everywhere_, double(picture.width) / picture.height);
}

FrameScene Sequence::frame(int index) {
  const Description description = describe(index);
  // Fitting looks at every vertex at all its places.
  const bool same_view = description.view == first_.view;
  FrameScene frame{scene_of(description, index), same_view ? camera_ : camera_of(description.view),
                   description.picture};
  Camera& camera = frame.camera;
  if (motion_.orbit == Orbit::camera) {
    camera.eye = turned_point(turn(index, 1), camera.eye);
    camera.target = turned_point(turn(index, 1), camera.target);
    camera.up = turned_direction(turn(index, 1), camera.up);
  }
  frame.scene.lights = make_lights(description, camera);
  if (motion_.orbit == Orbit::light)
    for (Light& light : frame.scene.lights) {
      light.direction = turned_direction(turn(index, 1), light.direction);
      light.position = turned_point(turn(index, 1), light.position);
    }
  return frame;
}

}  // namespace scanlit::studio
