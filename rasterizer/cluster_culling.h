// Which clusters of a mesh cannot give a fragment, and which need no clipping: decided from their
// bounds alone, and never against what their triangles themselves would say.
#pragma once

#include "rasterizer/mesh/clusters.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

enum class ClusterView {
  outside,      // of the picture, or of near and far: no triangle gives a fragment
  back_facing,  // inside, and every triangle faces away; only where back faces are not drawn
  inside,       // of near, far and guard band: every outcode is 0
  crossing      // or not known
};

/// One draw's constants of the tests, in double.
class ClusterCuller {
 public:
  ClusterCuller(const Draw& draw, const Viewport& viewport);

  ClusterView view(const Cluster& cluster) const;
  /// Of anything the sphere (object space) holds; never back_facing.
  ClusterView view(const Sphere& bounds) const;

  /// No vertex of an `inside` or `back_facing` cluster has a larger ScreenVertex::depth.
  float nearest_depth(const Cluster& cluster) const;
};

}  // namespace scanlit
