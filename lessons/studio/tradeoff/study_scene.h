// The picture that `scanlit tradeoff` draws in many ways.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lessons/studio/tradeoff/measurement.h"
#include "rasterizer/render.h"
#include "rasterizer/scene.h"

namespace scanlit::studio {

constexpr int study_width = 480, study_height = 360;

/// The default: what each axis departs from.
constexpr const char* study_shape = "teapot:8";
constexpr const char* study_model = "blinn-phong:kd=.5/.47/.42,ks=.4,n=60";

struct StudyScene {
  Scene scene;
  Camera camera;
};

/// A built-in shape, or a mesh of it, under a key light and a weak fill, far away. The camera is
/// that of the shape, whatever its tessellation.
StudyScene study_scene(const std::string& shape, const std::string& model = study_model);

/// Two triangles, a wall that reaches from beside the viewer far away, under a lamp: what
/// perspective matters to. (On a floor it does not matter along a row of pixels.)
StudyScene wall_scene();

/// A ball of 960 triangles under 16 lights, far away: what a tolerance matters to. (Under two
/// lights what it saves is less than what its bounds cost.)
StudyScene lights_scene();

/// The engine, on one thread whatever the settings say.
Candidate engine_candidate(std::shared_ptr<Renderer> renderer,
                           std::shared_ptr<const StudyScene> study, const std::string& series,
                           const std::string& label, RenderSettings settings = {});

ExactPicture reference_of(const StudyScene& study);

}  // namespace scanlit::studio
