// A camera that stands as near as it can with the whole scene in its picture.
#pragma once

#include "rasterizer/camera.h"
#include "rasterizer/scene.h"

namespace scanlit::studio {

/// A copy of `camera` that keeps its direction, and moves (orthographic: also resizes) so that the
/// scene just fits the picture with a margin; near and far clear the scene. Tighter than framed(),
/// which sees only a sphere around it.
Camera fitted(const Camera& camera, const Scene& scene, double aspect);

/// right, up and back (towards the viewer): the camera's axes in world space.
glm::dmat3 viewer_axes(const Camera& camera);

}  // namespace scanlit::studio
