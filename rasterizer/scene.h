// What a picture is made of: objects, materials, lights.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "rasterizer/camera.h"
#include "rasterizer/mesh.h"
#include "rasterizer/reflection_model.h"
#include "rasterizer/vec.h"

namespace scanlit {

/// Where the reflection model is evaluated: once per face, at the vertices (colours interpolated),
/// or at every fragment (normals interpolated).
enum class Shading { flat, gouraud, phong };

/// The lecture's two colour forms.
///   tinted:  I = Ka Ia + {Kd (N.L) + Ks (N.H)^n} Ii              colour lives in Ka, Kd, Ks and
///                                                                 the light tints both parts
///   plastic: I = {Ka Ia + Kd (N.L) Ii} object_colour + Ks (N.H)^n Ii light_colour
enum class ColourForm { tinted = 1, plastic = 2 };

/// Which way the surface is brushed: the field of tangents that anisotropic models follow, in
/// object space (how they come to world space, tangents.h says).
///   around    in circles about the axis through `centre`, as on a lathe
///   along     along the axis, as by a straight brush
///   texcoord  in which the texture coordinate u grows; on a mesh without any, as `around`
/// Where a field has no direction (on the axis of `around`, where the surface faces along the axis
/// of `along`, where u is constant), another direction in the surface takes its place.
enum class TangentField { around, along, texcoord };
struct Tangents {
  TangentField field = TangentField::around;
  glm::vec3 axis{0, 1, 0};  // any length but 0
  glm::vec3 centre{0};

  friend bool operator==(const Tangents&, const Tangents&) = default;
};

struct Material {
  std::shared_ptr<const ReflectionModel> model;
  Rgb<double> ka{0.1};  // ambient reflectance
  // To ka is added this share of the model's diffuse part, lit and seen head-on, at every point:
  // where that varies over the surface, its ambient reflectance does, too.
  double ambient_share = 0;  // 0..1
  ColourForm form = ColourForm::tinted;
  Rgb<double> object_colour{1.0};  // form 2 only
  Tangents tangents{};

  friend bool operator==(const Material&, const Material&) = default;
};

/// Which faces are drawn. `automatic` is `front` for a closed mesh and `both` for any other; a back
/// face is shaded with its normal flipped to the viewer's side.
enum class Sides { automatic, front, both };

struct Object {
  std::shared_ptr<const Mesh> mesh;   // not changed while a Renderer lives that has drawn it
  glm::mat4 world_from_object{1.0f};  // affine
  Material material;
  Shading shading = Shading::phong;
  Sides sides = Sides::automatic;
  std::string name;
};

enum class LightKind { directional, point, spot };

/// A light of scalar intensity Ii and a colour. A white diffuser (Kd = 1) lit head-on by Ii = 1
/// shows radiance 1.
struct Light {
  LightKind kind = LightKind::directional;
  double intensity = 1;           // Ii, >= 0
  Rgb<double> colour{1.0};        // >= 0
  glm::dvec3 direction{0, 0, 1};  // directional: towards the light; spot: where it points
  glm::dvec3 position{0, 0, 0};   // point and spot, world space
  // Point and spot: Ii / (constant + linear d + quadratic d^2), d the distance in world units.
  // (1,0,0) is no fall-off, (0,0,1) inverse square.
  double constant = 1, linear = 0, quadratic = 0;
  // Spot: full inside inner_deg of its axis, zero outside outer_deg, smooth between;
  // 0 <= inner < outer <= 90.
  double inner_deg = 20, outer_deg = 30;

  friend bool operator==(const Light&, const Light&) = default;
};

struct Scene {
  std::vector<Object> objects;
  std::vector<Light> lights;
  Rgb<double> ambient{1.0};     // Ia times its colour; form 2 uses its mean as the scalar Ia
  Rgb<double> background{0.0};  // linear; where it is not black, alpha there is still 0
};

/// Throws Error naming the object or light and the field: no mesh or model, NaN or Inf, a transform
/// that is not affine, a negative intensity or colour, a zero direction or axis of tangents,
/// fall-off that is zero or negative somewhere, spot angles out of order, more than 2^31 - 1
/// triangles or 2^32 - 1 vertices in all.
void validate(const Scene& scene);

/// A sphere in world space that holds every object.
Sphere bounding_sphere(const Scene& scene);

}  // namespace scanlit
