// The pipeline: read this first. It tells the whole way of the data, in order; each number is
// elaborated in the file named beside it.
//
//   (1) mesh             mesh.h             a file or a shape becomes flat arrays      object space
//       clusters         mesh/clusters.h    and is cut into clusters of triangles      object space
//   (2) camera, scene    camera.h, scene.h  where things are, and who looks            world
//       draws            draw.h             an object made ready for one frame         clip space
//   (3) vertex stage     vertex_stage.cpp   the vertices of a cluster that may be seen clip space
//   (4) clip             clip.cpp           the few triangles that leave the volume    clip
//   (5) project, snap    vertex_stage.cpp   divide by w, round to 1/256 pixel          screen space
//   (6) assembly         assembly.cpp       clusters and triangles that cannot be seen screen
//                                           are dropped (cluster_culling.h; occlusion.h with
//                                           occluder_depth.h; triangle_culling.h), the rest sorted
//                                           into tiles (binning.h); sites to be lit are found
//                                           (site_finder.h)
//   (7) scan conversion  scan_conversion.h  which triangle is nearest at each pixel    screen
//                                           (in which order, and what is hidden:
//                                           tile_triangles.h, coarse_depth.h; many rows at
//                                           once: row_spans.h; where triangles are tiny, many
//                                           of them: tiny_triangles.h)
//   (8) resolve          resolve.h          visible fragments, gathered into spans     screen
//                                           (fragment_span.h, filled in span_filling.h)
//                                           (what varies in them: planes.h, barycentric.h; which
//                                           may be interpolated, on request: strides.h)
//   (9) shading          shading.cpp        flat, Gouraud, Phong: where they differ    world
//       surface          surface.h          attributes at faces, vertices, fragments   object
//       placement        placement.h        normals and V                              world
//       lighting         lighting.cpp       the reflection model, under every light    world
//                                           (radiance.h: the sum over the lights)
//       tangents         tangents.h         which way the surface is brushed           world
//  (10) framebuffer      framebuffer.h      linear light, or 8-bit codes (pixel_codes.h),
//                                           written a tile at a time (tile_colours.h)
//  (11) image            image.h            a file
//
// Reflection models plug into (9) through reflection_model.h; how to write one is said at the top
// of formula_model.h. Other stages plug in through stages.h.
//
// Visibility comes first and shading after it, once per visible fragment: what is hidden is never
// shaded. render.cpp runs (3) to (6) for chunks of clusters, one cluster after the other, and then
// (7) to (10) for tiles (tile.cpp), both in parallel and small enough to stay in the cache. Where
// much may be hidden behind a few large triangles, these go through (3) to (6) first. What may
// stand from the last frame, reuse.h says.
//
// Conventions, said once:
//  * Object and world space are right-handed. The camera looks along -z of its own space, +y up.
//  * Clip space: a point is inside where -w <= x <= w, -w <= y <= w, 0 <= z <= w.
//  * Depth is z / w: 1 at the near plane, 0 at the far plane (or at infinity). Larger is nearer.
//    Reversed so, float is densest where perspective is sparsest: far distances keep precision.
//    What lies exactly on the far plane, at depth 0, is not drawn.
//  * Screen space: x to the right, y down, row 0 on top; pixel (i, j) has its centre at
//    (i + 1/2, j + 1/2). Positions are 24.8 fixed point: integers in 1/256 pixel.
//  * Of two fragments at exactly equal depth the one drawn first stays (object order, then triangle
//    order), so that the picture depends neither on threads nor on what was skipped.
//  * A front face is counter-clockwise seen by the viewer (clockwise in the y-down numbers here).
//  * Colours are linear light; directions are unit vectors that leave the surface.
//  * Stages (3) to (7) use one fixed order of unfused operations: coverage, ids and depth are the
//    same to the bit on every processor. Only shading may differ, by rounding.
#pragma once

#include <atomic>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <span>

#include "rasterizer/aligned_vector.h"
#include "rasterizer/mesh/clusters.h"
#include "rasterizer/render.h"
#include "rasterizer/screen.h"

namespace scanlit {

// ------------------------------------------------------------------------------ (3) vertex stage

/// A homogeneous position in clip space, before division by w.
struct ClipVertex {
  float x, y, z, w;
};

/// A vertex on the screen: position in 1/256 pixel, depth in [0, 1], and 1/w, which interpolates
/// linearly on the screen where attributes do not. |x|, |y| < 2^24: the guard band (Viewport).
struct ScreenVertex {
  std::int32_t x, y;
  float depth;
  float inv_w;
};

/// Bits of an outcode: which planes a clip-space vertex is outside of. The four side planes are
/// those of the guard band, not of the picture: see Viewport.
enum Outside : std::uint8_t {
  outside_near = 1,
  outside_far = 2,
  outside_left = 4,
  outside_right = 8,
  outside_bottom = 16,
  outside_top = 32,
  out_of_range = 64,  // a coordinate beyond 1e18, or NaN: such a vertex's triangles are not drawn
};

/// An object made ready for one frame.
struct Draw {
  const Object* object;
  const Mesh* mesh;
  std::shared_ptr<const MeshClusters> clusters;
  std::uint32_t index;  // in Scene::objects
  glm::mat4 clip_from_object;
  glm::mat3 normal_from_object;  // world normal = this * object normal, not yet unit
  bool draw_back_faces;
  bool mirrored;            // the transform reverses orientation
  bool outside = false;     // of the view, as a whole
  bool occluder = false;    // drawn first, to see what is behind it (occlusion.h)
  bool hidden = false;      // behind occluders, as a whole
  bool may_stride = false;  // strides.h
  Illumination illumination{};
};

/// A cluster's vertices on the screen, and which planes each is outside of. Element i is the
/// cluster's own vertex i; x and y stand apart once more, for vectors to gather.
struct ClusterVertices {
  static constexpr int capacity = 256;

  ScreenVertex screen[capacity];
  std::int32_t x[capacity], y[capacity];
  std::uint8_t outcodes[capacity];
  std::uint8_t any_outcode;  // outside of any plane: the bitwise or of all
  float nearest;             // the greatest depth, where none is outside
};

// -------------------------------------------------------------------------------------- (4) clip

/// A piece of a triangle that had to be cut, and where its corners lie in it.
struct ClippedTriangle {
  ScreenVertex vertices[3];
  float barycentric[3][3];  // [corner][vertex of the source triangle]; rows sum to 1
};

/// Cuts a triangle by the planes in `outcodes` (those that at least one of its vertices is outside
/// of) and appends the pieces. A cut point depends on the two ends of its edge alone, taken from
/// inside to outside: two triangles that share an edge cut it at the same point.
void clip(const ClipVertex (&triangle)[3], unsigned outcodes, const Viewport& viewport,
          std::vector<ClippedTriangle>& pieces);

// --------------------------------------------------------------------------- (5) project and snap

/// A triangle on the screen. twice_area is in (1/256 pixel)^2: positive if it faces the viewer,
/// negative if not, 0 if it has no area there.
struct ScreenTriangle {
  ScreenVertex vertices[3];
  std::int64_t twice_area;
};

/// The edge function: twice the signed area of (a, b, p). Positive where p lies on the inner side
/// of the edge a -> b of a front face; exact (see Viewport).
inline std::int64_t edge_function(const ScreenVertex& a, const ScreenVertex& b, std::int64_t px,
                                  std::int64_t py) {
  return std::int64_t(b.y - a.y) * (px - a.x) - std::int64_t(b.x - a.x) * (py - a.y);
}

inline ScreenTriangle screen_triangle(const ScreenVertex& a, const ScreenVertex& b,
                                      const ScreenVertex& c) {
  return {{a, b, c}, edge_function(a, b, c.x, c.y)};
}

// ---------------------------------------------------------------------------------- (6) assembly

/// A triangle that scan conversion will see, or a piece of one that was cut: one line of the cache.
struct alignas(cache_line) DrawnTriangle {
  ScreenVertex vertices[3];
  std::uint32_t draw;      // Draw::index
  std::uint32_t triangle;  // in the mesh
  std::uint32_t chunk;     // which holds it
  std::uint32_t piece;     // in the chunk's pieces, or not_cut

  static constexpr std::uint32_t not_cut = 0xffffffffu;
};

/// Of two triangles, the one that is drawn first: at equal depth it stays.
inline bool drawn_before(const DrawnTriangle& a, const DrawnTriangle& b) {
  return a.draw != b.draw ? a.draw < b.draw : a.triangle < b.triangle;
}

/// Flat and Gouraud: the places where the reflection model is evaluated before any fragment is, and
/// the colours it gave. Phong has none.
struct LitSites {
  struct Site {
    std::uint32_t element;  // of the mesh: a triangle (flat), or a vertex (Gouraud)
    bool from_behind;       // its normal is flipped
  };
  std::vector<Site> sites;
  std::vector<std::uint16_t> corners;  // Gouraud: the sites of triangle i are 3 i .. 3 i + 2; flat:
                                       // none, the site of triangle i is i
  // Linear RGB of each site, and 0: four numbers are copied at once. Parts only where they are
  // asked for. Longer than `sites` by a vector, for the last to be stored whole.
  std::vector<glm::vec4> colour, ambient, diffuse, glossy;
};

/// What one tile gets of one chunk.
struct Bin {
  std::uint32_t begin = 0, end = 0;  // in Chunk::entries
  Rect touched{};                    // the pixels in the tile that they may touch
};

/// Triangles of one cluster that lie in one tile, in whole or in part.
struct BinEntry {
  std::uint32_t begin, end;  // in Chunk::triangles
  float nearest;             // the greatest depth of any of them, or more
  Rect touched;              // the pixels in the tile that they may touch
  std::int32_t pixels;       // in their boxes, summed: an estimate of the work
};

/// Some clusters of one draw, and what assembly made of them.
struct Chunk {
  const Draw* draw = nullptr;
  std::uint32_t index = 0;  // in Frame::chunks
  std::uint32_t first_cluster = 0, end_cluster = 0;
  std::vector<DrawnTriangle> triangles;
  std::vector<ClippedTriangle> pieces;  // (4)
  LitSites lit;                         // (9)
  int first_tile = 0;                   // bins[i] is tile first_tile + i's
  std::vector<Bin> bins;
  std::vector<BinEntry> entries;
  FrameStats counts;
  // (8) stride_of() each triangle (strides.h), 0 where it is not known yet. Null: all are 1.
  std::unique_ptr<std::atomic<std::uint8_t>[]> strides;

  std::size_t number_of(const DrawnTriangle& t) const { return std::size_t(&t - triangles.data()); }
};

class Occlusion;

/// Everything known of the frame that is being drawn. Each stage reads what earlier ones filled.
struct Frame {
  const Scene& scene;
  const Camera& camera;
  const RenderSettings& settings;
  Viewport viewport;
  TileGrid grid;
  std::vector<Draw> draws;               // (2)
  std::vector<Chunk> chunks;             // (6)
  const Occlusion* occlusion = nullptr;  // (6); null: what is hidden is not known
  bool with_parts = false;               // colours are wanted in parts, too
  Viewer viewer = viewer_of(camera, viewport.width, viewport.height);
  ColourFormat format = ColourFormat::linear_float;
  bool colour_alone = false;  // of what fragments are shaded for

  const Draw& draw_of(const DrawnTriangle& t) const { return draws[t.draw]; }
};

/// (3) and (5) for the vertices of a cluster.
void transform_vertices(const Draw& draw, const Cluster& cluster, const Viewport& viewport,
                        ClusterVertices& vertices);
/// One vertex, by the same operations in the same order: the same bits.
ClipVertex transform(const Draw& draw, const glm::vec3& object_position);
ScreenVertex project(const ClipVertex& vertex, const Viewport& viewport);

/// (3) to (6), and (9) at faces and vertices, for a chunk whose draw and clusters are set.
void assemble(const Frame& frame, Chunk& chunk, FrameStats& stats);
/// Of that, (9) alone.
void light_chunk(const Frame& frame, Chunk& chunk, FrameStats& stats);

// --------------------------------------------------------------------------- (7) scan conversion

/// Which triangle: its number in VisibilityTile::triangles.
using TriangleId = std::uint32_t;
constexpr TriangleId no_triangle = 0xffffffffu;

/// The nearest triangle and its depth, for each sample of each pixel of a tile. Sample s of pixel
/// (x, y) is element (s * height + y - y_begin) * stride + x - x_begin. Outside of `touched` what
/// stands there means nothing: no triangle is there.
struct VisibilityTile {
  Rect rect;
  Rect touched;
  int stride = 0;
  int samples = 1;
  std::vector<const DrawnTriangle*> triangles;  // that may touch the tile
  std::uint32_t only_draw = no_id;              // whose they all are, if they are of one
  AlignedVector<float> depth;
  AlignedVector<TriangleId> triangle;

  /// Nothing is covered yet; only `touched_pixels` will be.
  void reset(const Rect& tile, const Rect& touched_pixels, int sample_count);
  std::size_t row(int sample, int y) const {
    const int height = rect.y_end - rect.y_begin;
    return std::size_t(sample * height + y - rect.y_begin) * std::size_t(stride);
  }
};

/// A sample's offset from its pixel's centre, in 1/256 pixel.
struct SampleOffset {
  int x, y;
};
/// The positions for 1, 4, 8 or 16 samples; those of the Direct3D 11 and Vulkan standard patterns,
/// whose grid of 1/16 pixel snaps exactly.
std::span<const SampleOffset> sample_offsets(int samples);

struct VisibleColumns;
/// Scan-converts one of the tile's triangles, at least in the columns where it may be seen; null:
/// in all of them.
void scan_convert(TriangleId id, VisibilityTile& visibility, const VisibleColumns* columns);

}  // namespace scanlit
