// What each frame of a sequence shows: the scene as it is described, with parameters swept and
// camera, objects or lights turned about the scene's centre.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/studio/description.h"
#include "lessons/studio/frames/sweep.h"
#include "lessons/studio/render_options.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {

/// What goes once around in a sequence; the frame after the last would be the first again.
enum class Orbit { none, camera, object, light };
extern const Choices<Orbit> orbits;

struct Motion {
  int frames = 36;
  Orbit orbit = Orbit::none;
  std::optional<glm::dvec3> axis;  // of the orbit; default: the camera's up
  std::vector<PathSweep> sweeps;   // of what a scene file says
};

struct FrameScene {
  Scene scene;
  Camera camera;
  Picture picture;
};

class Sequence {
 public:
  /// Reads and checks frames spread over the whole sequence, the first and the last among them.
  /// Throws Error.
  Sequence(std::string input, std::vector<GivenEdit> edits, Motion motion);

  /// Size and mesh files are those of every frame.
  const Description& first() const { return first_; }

  /// Keeps the meshes from one call to the next. Throws Error.
  FrameScene frame(int index);

 private:
  Description describe(int index) const;
  void find_bounds(const std::vector<int>& samples);
  Scene scene_of(const Description& description, int index);
  Camera camera_of(View view) const;
  glm::dmat4 turn(int index, double direction) const;

  std::string input_;
  std::vector<GivenEdit> edits_;
  Motion motion_;
  Description first_;
  Meshes meshes_;
  glm::dvec3 centre_{0}, axis_{0, 1, 0};
  Scene everywhere_;  // the objects at all their places, as the camera of frame 0 sees them
  Camera camera_;     // of frame 0
  bool camera_swept_ = false;  // it sees the scene from different directions
};

}  // namespace scanlit::studio
