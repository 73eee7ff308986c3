// The comparison's scenes, drawn by OpenGL 3.3 on Mesa's llvmpipe, without a window (OSMesa).
//
// Everything in its favour that a caller may do: buffers are uploaded once, vertices interleaved,
// back faces culled, blending and dithering off. llvmpipe reads LP_NUM_THREADS from the environment
// when the context is made; LP_NATIVE_VECTOR_WIDTH=512 makes it crash (Mesa 22.3), 256 is best.
#pragma once

#include <string>
#include <vector>

#include "bench_scenes.h"
#include "picture_difference.h"

struct osmesa_context;

namespace scanlit::bench {

/// Where the picture goes: into the caller's memory at glFinish (OSMesaMakeCurrent's buffer), or
/// into a framebuffer object that glReadPixels reads.
enum class Target { buffer, framebuffer_object };

class OsmesaPeer {
 public:
  /// Throws Error where there is no such context.
  OsmesaPeer();
  OsmesaPeer(const OsmesaPeer&) = delete;
  OsmesaPeer& operator=(const OsmesaPeer&) = delete;
  ~OsmesaPeer();

  void prepare(const BenchScene& scene);
  /// Returns when the pixels are in picture().
  void draw(const BenchScene& scene, int frame, Target target);

  const Picture& picture() const { return picture_; }
  /// glReadPixels starts at the bottom row.
  Picture upside_down() const;

  /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 (Core Profile) Mesa 22.3.6"
  static std::string version();

 private:
  /// A mesh in the renderer's memory: OpenGL's names for it.
  struct Uploaded {
    unsigned vertex_array, buffers[2];
    int index_count;
  };

  void make_framebuffer_object();
  Uploaded upload(const Mesh& mesh) const;
  void drop_meshes();
  void draw_all(const BenchScene& scene, int frame) const;

  Picture picture_ = Picture(4 * std::size_t(picture_width) * picture_height);
  osmesa_context* context_ = nullptr;
  unsigned framebuffer_object_ = 0, program_ = 0;
  std::vector<Uploaded> meshes_;           // each mesh of the scene once
  std::vector<std::size_t> mesh_of_draw_;  // index in meshes_
};

}  // namespace scanlit::bench
