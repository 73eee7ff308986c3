#include "rasterizer/tangents.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "rasterizer/span_math.h"

namespace scanlit {

namespace {

/// A unit vector perpendicular to n, without any choice to make.
/// Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin, "Building an Orthonormal Basis,
/// Revisited", JCGT 6(1), 2017.
Vec3<Batch> any_perpendicular(const Vec3<Batch>& n) {
  const Batch sign = select(n.z < Batch(0), Batch(-1), Batch(1));
  const Batch a = Batch(-1) / (sign + n.z);
  return {Batch(1) + sign * n.x * n.x * a, sign * (n.x * n.y * a), -(sign * n.x)};
}

/// The direction projected into the surface of unit normal n, unit; `otherwise` where nothing of it
/// lies there.
Vec3<Batch> in_surface(const Vec3<Batch>& direction, const Vec3<Batch>& n,
                       const Vec3<Batch>& otherwise) {
  // Scaled by its largest component: squares of 1e-20 and of 1e20 leave float.
  const Batch largest = max(abs(direction.x), max(abs(direction.y), abs(direction.z)));
  const Vec3<Batch> d = direction * (Batch(1) / max(largest, Batch(1e-37f)));
  const Vec3<Batch> across = d - n * dot(n, d);
  // Within 1e-4 rad of the normal, what is left across it is rounding for the most part: without
  // the bound a plane that contains the axis would show noise instead of a brush.
  const Batch d2 = dot(d, d), across2 = dot(across, across);
  const auto has_direction = (across2 > Batch(1e-8f) * d2) & (largest > Batch(1e-37f));
  const Vec3<Batch> unit = across * (Batch(1) / sqrt(across2));
  // Near that bound the first projection leaves 1e-3 along n; the second one leaves nothing.
  const Vec3<Batch> again = unit - n * dot(n, unit);
  return select(has_direction, again * (Batch(1) / sqrt(dot(again, again))), otherwise);
}

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

/// The object's tangent field, made ready for its spans.
struct Field {
  bool along, texcoord;
  Vec3<Batch> axis, centre;     // object space; the axis unit
  glm::mat3 world_from_object;  // linear part, scaled: lengths do not matter, float's range does
  Vec3<Batch> side[2];          // world space, unit: where the field has no direction
};

Field field_of(const Draw& draw) {
  const Tangents& tangents = draw.object->material.tangents;
  const glm::dvec3 axis = glm::normalize(glm::dvec3(tangents.axis));
  glm::dmat3 linear(draw.object->world_from_object);
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(linear[i / 3][i % 3]));
  if (largest > 0) linear /= largest;

  // Two directions across the axis, so that a flat end of a cylinder is brushed straight.
  const glm::dvec3 x(1, 0, 0), z(0, 0, 1);
  const glm::dvec3 side = glm::normalize(glm::cross(axis, std::abs(axis.z) < 0.9 ? z : x));
  const glm::dvec3 other = glm::cross(side, axis);
  return {.along = tangents.field == TangentField::along,
          .texcoord = follows_texcoord(draw),
          .axis = broadcast(axis),
          .centre = broadcast(tangents.centre),
          .world_from_object = glm::mat3(linear),
          .side = {broadcast(unit_or(linear * side, x)), broadcast(unit_or(linear * other, z))}};
}

/// In object space; not of texture coordinates.
Vec3<Batch> brushed_in_object(const Field& field, const Vec3<Batch>& position) {
  return field.along ? field.axis : cross(field.axis, position - field.centre);
}

}  // namespace

bool follows_texcoord(const Draw& draw) {
  return draw.object->material.tangents.field == TangentField::texcoord && draw.mesh &&
         !draw.mesh->tangents.empty();
}

Vec3<Batch> brushed(const Draw& draw, const Vec3<Batch>& object_position) {
  const Field field = field_of(draw);
  return transform(field.world_from_object, brushed_in_object(field, object_position));
}

void place_tangents(const Draw& draw, SurfaceSpan& surface) {
  const Field field = field_of(draw);
  for (int i = 0; i < surface.size; i += Batch::lanes) {
    const Vec3<Batch> n = load(surface.normal, i);
    const Vec3<Batch> in_object = field.texcoord
                                      ? load(surface.tangent, i)
                                      : brushed_in_object(field, load(surface.position, i));
    // Not the flatter one of the two sides: on a plane rounding would choose, pixel by pixel.
    const auto first_lies_flat = abs(dot(n, field.side[0])) < Batch(0.9f);
    const Vec3<Batch> side = select(first_lies_flat, field.side[0], field.side[1]);
    // A transform that flattens the object may leave neither a direction.
    const Vec3<Batch> instead = in_surface(side, n, any_perpendicular(n));
    store(in_surface(transform(field.world_from_object, in_object), n, instead), surface.tangent,
          i);
  }
}

}  // namespace scanlit
