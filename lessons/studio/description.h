// A picture as its author describes it, by a scene file or on the command line, before anything is
// loaded: what was left open is filled in when scene and camera are made of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "models/registry.h"
#include "rasterizer/camera.h"
#include "rasterizer/image.h"
#include "rasterizer/mesh.h"
#include "rasterizer/render.h"
#include "rasterizer/scene.h"

namespace scanlit::studio {

/// Where the viewer is. Without an eye the camera is placed so that everything fits the picture,
/// seen from the direction of azimuth and elevation.
struct View {
  std::optional<glm::dvec3> eye;
  std::optional<glm::dvec3> target;  // default: the middle of the scene
  glm::dvec3 up{0, 1, 0};
  double azimuth_deg = 30;    // around `up`, from the front to the right
  double elevation_deg = 25;  // above the horizon
  Projection projection = Projection::perspective;
  double fov_deg = 30;
  std::optional<double> height;  // orthographic; default: everything fits
  std::optional<double> near, far;
  bool viewer_at_infinity = false;

  friend bool operator==(const View&, const View&) = default;
};

/// A material whose ambient reflectance may be left to its model.
struct MaterialDescription {
  models::NamedModel model;
  std::optional<Rgb<double>> ka;
  ColourForm form = ColourForm::tinted;
  Rgb<double> object_colour{1.0};
  std::optional<Tangents> tangents;  // else the model's own, where it is a material that has some
};

struct ObjectDescription {
  std::string name;
  std::string mesh;              // a built-in shape or a mesh file
  std::filesystem::path folder;  // what a relative mesh file is relative to
  std::string where;             // "scene.toml:12:8", for messages; empty for the command line
  MeshOptions mesh_options;
  MaterialDescription material;
  Shading shading = Shading::phong;
  Sides sides = Sides::automatic;
  glm::mat4 world_from_object{1.0f};
};

struct Picture {
  int width = 960, height = 720;
  RenderSettings settings;
  ImageOptions image;

  Picture() { settings.samples = 4; }

  /// The settings, with a tolerance in codes of the file made one in those of the framebuffer: a
  /// brighter picture shows more, and where linear codes are finer than sRGB's, at most by the
  /// slope 1.055 / 2.4 that sRGB has at 1, they do, too.
  RenderSettings render_settings() const {
    RenderSettings result = settings;
    result.tolerance /= std::max(1.0, std::exp2(image.exposure_ev));
    if (image.encoding == Encoding::linear) result.tolerance *= 1.055 / 2.4;
    return result;
  }
};

struct Description {
  View view;
  Picture picture;
  std::vector<ObjectDescription> objects;
  std::vector<Light> lights;  // none: a key light over the viewer's left shoulder and a weak fill
  double ambient_intensity = 1;
  Rgb<double> ambient_colour{1.0};
  Rgb<double> background{0.03, 0.034, 0.042};
};

/// The ambient reflectance of a material that names none, as a share of what its model's diffuse
/// part shows when lit and seen head-on.
constexpr double ambient_share = 0.15;

/// What an object is made of where nobody says.
constexpr const char* default_model = "blinn-phong:kd=.5/.47/.42,ks=.4,n=60";

/// One mesh or shape with the default material, seen from the default view.
Description describe_object(const std::string& mesh);

/// Meshes by file or shape and by how their normals are made. Those that are there are not loaded.
using Meshes =
    std::map<std::tuple<std::filesystem::path, NormalWeight, double>, std::shared_ptr<const Mesh>>;

/// Loads the meshes, each file or shape once, and puts everything in its place. Lights stay as
/// described: see `lights`. Throws Error naming the place in the scene file.
Scene make_scene(const Description& description, Meshes& meshes);
Scene make_scene(const Description& description);

/// Throws Error naming the field.
Camera make_camera(const View& view, const Scene& scene, double aspect);

/// The lights described, or the default ones for this camera.
std::vector<Light> make_lights(const Description& description, const Camera& camera);

/// All of these, for a picture of the size described.
std::pair<Scene, Camera> make_scene_and_camera(const Description& description);

}  // namespace scanlit::studio
