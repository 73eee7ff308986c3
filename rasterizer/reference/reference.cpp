#include "rasterizer/reference/reference.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "rasterizer/draw.h"
#include "rasterizer/reference/surface_light.h"
#include "rasterizer/surface.h"

namespace scanlit {

namespace {

using glm::dvec2;
using glm::dvec3;

/// The nearest triangle at a pixel's centre, and where in it.
struct Hit {
  const Draw* draw = nullptr;
  std::uint32_t triangle = 0;
  bool back_facing = false;
  double depth = 0;         // what lies on the far plane, at 0, is not drawn
  double b[3];              // barycentric, perspective-correct
  double b_dx[3], b_dy[3];  // their growth to the next pixel, on the right and below
};

/// A triangle on the screen: a whole one, or a piece of one that was cut.
struct Piece {
  const Draw& draw;
  std::uint32_t triangle;
  const ClippedTriangle& corners;
  double inv_w[3];  // of the corners
};

/// 1/w of a piece's corner: in double where it is a vertex of the mesh. At a cut point w is what
/// cancellation has left of both ends', and clip() knows it better.
double inverse_w(const ClippedTriangle& piece, int corner, const double (&w)[3]) {
  for (int i = 0; i < 3; ++i)
    if (piece.barycentric[corner][i] >= 1) return 1 / w[i];
  return double(piece.vertices[corner].inv_w);
}

/// Whether a point on the edge a -> b is the triangle's: one infinitely little to the right of the
/// point, and infinitely less below it, would lie inside (the top-left rule).
bool owns_edge(const ScreenVertex& a, const ScreenVertex& b, bool front) {
  if (a.y != b.y) return (b.y > a.y) == front;
  return (a.x > b.x) == front;
}

/// Keeps the piece where it is the nearest at the pixel's centre.
void test_pixel(const Piece& piece, const ScreenTriangle& t, int x, int y, Hit& hit) {
  const auto& v = t.vertices;
  const std::int64_t px = std::int64_t(x) * subpixel + half_pixel;
  const std::int64_t py = std::int64_t(y) * subpixel + half_pixel;
  const bool front = t.twice_area > 0;
  double linear[3], step_x[3], step_y[3];  // the corners' weights, linear on the screen
  for (int k = 0; k < 3; ++k) {
    const ScreenVertex &a = v[(k + 1) % 3], &b = v[(k + 2) % 3];  // the edge across
    const std::int64_t edge = edge_function(a, b, px, py);        // exact: see Viewport
    if (edge == 0 ? !owns_edge(a, b, front) : (edge > 0) != front) return;
    const double area = double(t.twice_area);
    linear[k] = double(edge) / area;
    step_x[k] = double(b.y - a.y) * subpixel / area;
    step_y[k] = double(a.x - b.x) * subpixel / area;
  }
  const double depth = linear[0] * v[0].depth + linear[1] * v[1].depth + linear[2] * v[2].depth;
  if (!(depth > hit.depth)) return;  // of equal depth, the first one stays

  const bool behind = front == piece.draw.mirrored;
  hit = {&piece.draw, piece.triangle, behind, depth, {}, {}, {}};
  // Attributes over w, and 1/w, are linear on the screen; their quotient is the attribute.
  double sum = 0, sum_dx = 0, sum_dy = 0;
  for (int k = 0; k < 3; ++k) {
    sum += linear[k] * piece.inv_w[k];
    sum_dx += step_x[k] * piece.inv_w[k];
    sum_dy += step_y[k] * piece.inv_w[k];
  }
  for (int k = 0; k < 3; ++k) {
    const double b = linear[k] * piece.inv_w[k] / sum;
    const double b_dx = (step_x[k] * piece.inv_w[k] - b * sum_dx) / sum;
    const double b_dy = (step_y[k] * piece.inv_w[k] - b * sum_dy) / sum;
    for (int i = 0; i < 3; ++i) {
      const double share = double(piece.corners.barycentric[k][i]);
      hit.b[i] += b * share, hit.b_dx[i] += b_dx * share, hit.b_dy[i] += b_dy * share;
    }
  }
}

void draw_piece(const Piece& piece, const Viewport& viewport, std::vector<Hit>& hits) {
  const auto& v = piece.corners.vertices;
  const ScreenTriangle t = screen_triangle(v[0], v[1], v[2]);
  const bool faces_viewer = (t.twice_area > 0) != piece.draw.mirrored;
  if (t.twice_area == 0 || (!faces_viewer && !piece.draw.draw_back_faces)) return;
  const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int x_end = std::min(x_max / subpixel + 2, viewport.width);
  const int y_end = std::min(y_max / subpixel + 2, viewport.height);
  for (int y = std::max(y_min / subpixel - 1, 0); y < y_end; ++y)
    for (int x = std::max(x_min / subpixel - 1, 0); x < x_end; ++x)
      test_pixel(piece, t, x, y,
                 hits[std::size_t(y) * std::size_t(viewport.width) + std::size_t(x)]);
}

void draw_object(const Draw& draw, const glm::dmat4& clip_from_object, const Viewport& viewport,
                 std::vector<Hit>& hits) {
  constexpr unsigned all_planes =
      outside_near | outside_far | outside_left | outside_right | outside_bottom | outside_top;
  const Mesh& mesh = *draw.mesh;
  std::vector<ClippedTriangle> pieces;
  for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) {
    ClipVertex corners[3];
    double w[3];
    bool in_range = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3& position = mesh.positions[mesh.indices[3 * std::size_t(i) + k]];
      const ClipVertex& c = corners[k] = transform(draw, position);
      for (const float coordinate : {c.x, c.y, c.z, c.w})
        in_range &= std::abs(coordinate) <= 1e18f;  // see out_of_range
      w[k] = (clip_from_object * glm::dvec4(position, 1)).w;
    }
    if (!in_range) continue;
    pieces.clear();
    clip(corners, all_planes, viewport, pieces);
    for (const ClippedTriangle& piece : pieces)
      draw_piece({draw,
                  i,
                  piece,
                  {inverse_w(piece, 0, w), inverse_w(piece, 1, w), inverse_w(piece, 2, w)}},
                 viewport, hits);
  }
}

// ------------------------------------------------------------------------------------- attributes

/// An attribute at weights of a triangle's corners; `missing` where the mesh has none.
template <class D, class V>
D weighted(const std::vector<V>& attribute, const std::uint32_t* corner, const double (&b)[3],
           const D& missing) {
  if (attribute.empty()) return missing;
  return b[0] * D(attribute[corner[0]]) + b[1] * D(attribute[corner[1]]) +
         b[2] * D(attribute[corner[2]]);
}

ObjectPoint point_at(const Mesh& mesh, const std::uint32_t* corner, const double (&b)[3],
                     bool back_facing) {
  return {.position = weighted(mesh.positions, corner, b, dvec3(0)),
          .normal = weighted(mesh.normals, corner, b, dvec3(0)) * (back_facing ? -1.0 : 1.0),
          .texcoord = weighted(mesh.texcoords, corner, b, dvec2(0)),
          .colour = weighted(mesh.colours, corner, b, dvec3(1)),
          .tangent = weighted(mesh.tangents, corner, b, dvec3(0)),
          .has_tangent = !mesh.tangents.empty()};
}

/// Flat, Gouraud and Phong, and where they differ: at which points the model is evaluated.
Rgb<double> shade(const Scene& scene, const Camera& camera, const Hit& hit,
                  const dvec3& to_viewer) {
  const Object& object = *hit.draw->object;
  const Mesh& mesh = *object.mesh;
  const std::uint32_t* const corner = &mesh.indices[3 * std::size_t(hit.triangle)];
  const auto lit = [&](const ObjectPoint& p) {
    return radiance_in_double(scene, camera, object, p);
  };

  if (object.shading == Shading::gouraud) {
    Rgb<double> sum;
    for (int k = 0; k < 3; ++k) {
      const double at_corner[3] = {double(k == 0), double(k == 1), double(k == 2)};
      sum = sum + lit(point_at(mesh, corner, at_corner, hit.back_facing)) * hit.b[k];
    }
    return sum;
  }
  if (object.shading == Shading::flat) {
    ObjectPoint p = point_at(mesh, corner, {1. / 3, 1. / 3, 1. / 3}, false);
    const dvec3 a(mesh.positions[corner[0]]), b(mesh.positions[corner[1]]),
        c(mesh.positions[corner[2]]);
    p.normal = glm::cross(b - a, c - a) * (hit.back_facing ? -1.0 : 1.0);
    return lit(p);
  }
  ObjectPoint p = point_at(mesh, corner, hit.b, hit.back_facing);
  p.texcoord_dx = weighted(mesh.texcoords, corner, hit.b_dx, dvec2(0));
  p.texcoord_dy = weighted(mesh.texcoords, corner, hit.b_dy, dvec2(0));
  p.to_viewer = to_viewer;
  p.is_pixel = !mesh.texcoords.empty() && object.material.model->needs().texcoord_derivatives;
  return lit(p);
}

/// Where a pixel's surface lies and how it is turned.
void place(const Hit& hit, const Camera& camera, std::size_t pixel, ExactPicture& picture) {
  const Object& object = *hit.draw->object;
  const std::uint32_t* const corner = &object.mesh->indices[3 * std::size_t(hit.triangle)];
  const ObjectPoint p = point_at(*object.mesh, corner, hit.b, hit.back_facing);
  const dvec3 world(glm::dmat4(object.world_from_object) * glm::dvec4(p.position, 1));
  picture.distance[pixel] = glm::dot(camera.eye - world, towards_viewer(camera));
  picture.normal[pixel] = world_normal(object, p, towards_viewer(camera));
}

}  // namespace

ExactPicture::ExactPicture(int width_pixels, int height_pixels, const Rgb<double>& background)
    : width(width_pixels), height(height_pixels) {
  validate_size(width, height);
  const std::size_t count = std::size_t(width) * std::size_t(height);
  colour.assign(count, background);
  object.assign(count, no_id), triangle.assign(count, no_id);
  distance.assign(count, 0), normal.assign(count, dvec3(0));
}

ExactPicture render_reference(const Scene& scene, const Camera& camera, int width, int height) {
  validate(scene);
  validate(camera);
  ExactPicture picture(width, height, scene.background);
  const Viewport viewport{width, height};
  const glm::dmat4 projection = clip_from_world(camera, double(width) / height);
  ClusterCache clusters;
  std::vector<Draw> draws;
  for (const Object& object : scene.objects)
    draws.push_back(make_draw(object, std::uint32_t(draws.size()), projection, clusters));

  std::vector<Hit> hits(picture.pixel_count());
  for (const Draw& draw : draws)
    draw_object(draw, projection * glm::dmat4(draw.object->world_from_object), viewport, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i].draw) continue;
    const int x = int(i) % width, y = int(i) / width;
    picture.colour[i] =
        shade(scene, camera, hits[i], glm::normalize(pixel_to_eye(camera, width, height, x, y)));
    picture.object[i] = hits[i].draw->index;
    picture.triangle[i] = hits[i].triangle;
    place(hits[i], camera, i, picture);
  }
  return picture;
}

ExactPicture exact_picture(const Framebuffer& framebuffer) {
  ExactPicture picture(framebuffer.width, framebuffer.height, Rgb<double>());
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const float* const c = &framebuffer.colour[4 * i];
    picture.colour[i] = {double(c[0]), double(c[1]), double(c[2])};
  }
  if (!framebuffer.object_id.empty())
    picture.object = framebuffer.object_id, picture.triangle = framebuffer.triangle_id;
  return picture;
}

}  // namespace scanlit
