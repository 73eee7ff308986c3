// The studio in which most lessons take their pictures: an object, two lights, a dark wall.
#pragma once

#include "lessons/studio/drawing/canvas.h"
#include "lessons/studio/framing.h"
#include "rasterizer/render.h"

namespace scanlit::studio {

/// A shape or mesh file in a material, both as on the command line: ("teapot:8", "phong:n=20").
/// It reflects a tenth of its diffuse colour of the ambient light.
Object make_object(const std::string& shape, const std::string& model,
                   Shading shading = Shading::phong);

/// The same in a model that is there already, such as a lesson's own formula.
Object make_object(const std::string& shape, std::shared_ptr<const ReflectionModel> model,
                   Shading shading = Shading::phong);

/// Far away in this direction.
Light far_light(const glm::dvec3& towards_light, double intensity);

/// The objects before a dark wall, under a light over the viewer's left shoulder, intensity 1, and
/// a weak one from the right.
Scene make_stage(const std::vector<Object>& objects);

/// The scene with 16 samples a pixel.
Framebuffer photograph(const Scene& scene, const Camera& camera, int width, int height,
                       FrameStats* stats = nullptr);
/// The same from as near to it as the scene fits, looking from `eye` at the origin.
Framebuffer photograph(const Scene& scene, const glm::dvec3& eye, int width, int height,
                       FrameStats* stats = nullptr);

}  // namespace scanlit::studio
