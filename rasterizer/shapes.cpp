#include "rasterizer/shapes.h"

#include <algorithm>
#include <charconv>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_flatten.h"
#include "rasterizer/mesh/shape_surfaces.h"

namespace scanlit {
namespace {

struct Shape {
  ShapeInfo info;
  bool closed;
  detail::PolyMesh (*make)(int n);
};

// The largest tessellation is that of about 10 million triangles.
const std::vector<Shape>& all() {
  using namespace detail;
  static const std::vector<Shape> shapes = {
      {{"plane", "square of side 2 at z = 0, facing +z", "quads per side; 2 N^2 triangles", 1, 1,
        2236},
       false,
       make_plane},
      {{"cube", "side 2, sharp edges", "quads per side of a face; 12 N^2 triangles", 1, 1, 912},
       true,
       make_cube},
      {{"sphere", "radius 1, poles on y, of meridians and parallels",
        "stacks, with 2 N slices; 4 N^2 - 4 N triangles", 64, 2, 1600},
       true,
       make_sphere},
      {{"icosphere", "radius 1, triangles of nearly equal size",
        "parts of an icosahedron's edge; 20 N^2 triangles", 16, 1, 707},
       true,
       make_icosphere},
      {{"cylinder", "radius 1, height 2, axis y, with flat ends",
        "segments around, N / 4 up and across; about 1.5 N^2 triangles", 64, 3, 2560},
       true,
       make_cylinder},
      {{"cone", "base radius 1, height 2, apex up the y axis, with a flat base",
        "segments around, N / 4 up and across; about N^2 triangles", 64, 3, 3160},
       true,
       make_cone},
      {{"torus", "major radius 0.7, minor 0.3, axis z",
        "segments around the tube, 2 N along the ring; 4 N^2 triangles", 32, 3, 1581},
       true,
       make_torus},
      {{"trefoil", "trefoil knot of tube radius 0.18, within radius 1, seen best along z",
        "segments around the tube, 8 N along the knot; 16 N^2 triangles", 24, 3, 790},
       true,
       make_trefoil},
      {{"teapot", "Newell's, open, spout towards +x, 2 wide, centred, y up",
        "segments per side of its 32 patches; about 64 N^2 triangles", 16, 2, 395},
       false,
       make_teapot},
  };
  return shapes;
}

std::string_view name_part(std::string_view specification) {
  return specification.substr(0, specification.find(':'));
}

const Shape* find(std::string_view name) {
  const auto found = std::ranges::find(all(), name, [](const Shape& s) { return s.info.name; });
  return found == all().end() ? nullptr : &*found;
}

int tessellation(std::string_view specification, const ShapeInfo& info) {
  const std::size_t colon = specification.find(':');
  if (colon == std::string_view::npos) return info.default_tessellation;
  const std::string_view digits = specification.substr(colon + 1);
  int n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (error != std::errc() || end != digits.data() + digits.size() || n < info.min_tessellation ||
      n > info.max_tessellation)
    throw Error(std::string(specification),
                "'" + std::string(digits) + "' is not a whole number from " +
                    std::to_string(info.min_tessellation) + " to " +
                    std::to_string(info.max_tessellation) + " (" + info.parameter + ")");
  return n;
}

}  // namespace

const std::vector<ShapeInfo>& shapes() {
  static const std::vector<ShapeInfo> infos = [] {
    std::vector<ShapeInfo> result;
    for (const Shape& shape : all()) result.push_back(shape.info);
    return result;
  }();
  return infos;
}

bool is_shape(std::string_view specification) { return find(name_part(specification)) != nullptr; }

Mesh make_shape(std::string_view specification) {
  const std::string_view name = name_part(specification);
  const Shape* shape = find(name);
  if (!shape) {
    std::vector<std::string> names;
    for (const ShapeInfo& info : shapes()) names.push_back(info.name);
    throw Error("unknown shape '" + std::string(name) + "'" + did_you_mean(name, names));
  }
  Mesh mesh = detail::flatten(shape->make(tessellation(specification, shape->info)), {},
                              std::string(specification), {});
  mesh.closed = shape->closed;
  return mesh;
}

}  // namespace scanlit
