#include "lessons/studio/render_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "lessons/studio/text.h"
#include "rasterizer/error.h"
#include "rasterizer/shapes.h"

namespace scanlit::studio {
namespace {

using Text = const std::string&;

void set_shading(Description& d, Text where, Text text) {
  const Shading shading = choose(where, "shading", text, shadings);
  for (ObjectDescription& object : d.objects) object.shading = shading;
}

void set_model(Description& d, Text where, Text text) {
  MaterialDescription material;
  try {
    material.model = models::make(text);
  } catch (const Error& error) {
    throw Error(where, error.what());
  }
  for (ObjectDescription& object : d.objects) {
    material.tangents = object.material.tangents;  // how the surface is brushed stays
    object.material = material;
  }
}

void set_tangents(Description& d, Text where, Text text) {
  const Tangents tangents = choose(where, "tangents", text, brushes);
  for (ObjectDescription& object : d.objects) object.material.tangents = tangents;
}

void set_ka(Description& d, Text where, Text text) {
  const Rgb<double> ka = parse_colour(where, text, reflectance_range);
  for (ObjectDescription& object : d.objects) object.material.ka = ka;
}

void set_object_colour(Description& d, Text where, Text text) {
  const Rgb<double> colour = parse_colour(where, text, reflectance_range);
  for (ObjectDescription& object : d.objects) {
    object.material.form = ColourForm::plastic;
    object.material.object_colour = colour;
  }
}

void set_sides(Description& d, Text where, Text text) {
  const Sides sides = choose(where, "value", text, all_sides);
  for (ObjectDescription& object : d.objects) object.sides = sides;
}

void set_crease(Description& d, Text where, Text text) {
  const double crease_deg = parse_number(where, text, crease_range_deg);
  for (ObjectDescription& object : d.objects) object.mesh_options.crease_deg = crease_deg;
}

void set_normals(Description& d, Text where, Text text) {
  const NormalWeight weight = choose(where, "weight", text, normal_weights);
  for (ObjectDescription& object : d.objects) object.mesh_options.normal_weight = weight;
}

/// A direction replaces the lights; the first one given removes those of the scene.
void set_light(Description& d, Text where, Text text) {
  Light light;
  light.direction = parse_vector(where, text);
  if (light.direction == glm::dvec3(0)) throw Error(where, "the direction is the zero vector");
  d.lights = {light};
}

void set_ambient(Description& d, Text where, Text text) {
  d.ambient_intensity = parse_number(where, text, light_range);
}

void set_background(Description& d, Text where, Text text) {
  d.background = parse_colour(where, text, light_range);
}

void set_azimuth(Description& d, Text where, Text text) {
  d.view.azimuth_deg = parse_number(where, text, any_angle_deg);
  d.view.eye.reset();
}

void set_elevation(Description& d, Text where, Text text) {
  d.view.elevation_deg = parse_number(where, text, elevation_range_deg);
  d.view.eye.reset();
}

void set_size(Description& d, Text where, Text text) {
  std::tie(d.picture.width, d.picture.height) = parse_size(where, text);
}

void set_samples(Description& d, Text where, Text text) {
  d.picture.settings.samples = check_samples(where, parse_integer(where, text, {1, 16}));
}

void set_interpolation(Description& d, Text where, Text text) {
  const Choices<Interpolation> interpolations{{"perspective", Interpolation::perspective},
                                              {"screen-linear", Interpolation::screen_linear}};
  d.picture.settings.interpolation = choose(where, "interpolation", text, interpolations);
}

const char* const surface = "Surface";
const char* const light = "Light";
const char* const camera = "Camera";
const char* const picture = "Picture";

// In the order of --help; where two touch the same thing, the later one wins.
const Edit all_edits[] = {
    {surface, "--shading", "MODE", "flat, gouraud or phong (phong)", set_shading},
    {surface, "--model", "SPEC", "reflection model, see scanlit models", set_model},
    {surface, "--ka", "COLOUR", "ambient reflectance (.15 of the model's kd)", set_ka},
    {surface, "--object-colour", "COLOUR", "the lecture's second form, this its object colour",
     set_object_colour},
    {surface, "--tangents", "FIELD", "the brush: around or along x, y or z, or texcoord (around y)",
     set_tangents},
    {surface, "--sides", "SIDES", "faces drawn: automatic, front or both (automatic)", set_sides},
    {surface, "--crease", "DEG", "split normals at edges sharper than this", set_crease},
    {surface, "--normals", "WEIGHT", "faces count by angle or area (angle), if the file has none",
     set_normals},
    {light, "--light", "X,Y,Z", "one directional light, from there (a key and a fill)", set_light},
    {light, "--ambient", "IA", "intensity of the ambient light (1)", set_ambient},
    {light, "--background", "COLOUR", "what is behind everything", set_background},
    {camera, "--azimuth", "DEG", "seen from the front (0), right (90), ... (30)", set_azimuth},
    {camera, "--elevation", "DEG", "seen from so far above the horizon (25)", set_elevation},
    {camera, "--eye", "X,Y,Z", "the viewer's place (far enough to see everything)",
     [](Description& d, Text where, Text text) { d.view.eye = parse_vector(where, text); }},
    {camera, "--target", "X,Y,Z", "what the viewer looks at (the middle of the scene)",
     [](Description& d, Text where, Text text) { d.view.target = parse_vector(where, text); }},
    {camera, "--up", "X,Y,Z", "which way is up (0,1,0)",
     [](Description& d, Text where, Text text) { d.view.up = parse_vector(where, text); }},
    {camera, "--fov", "DEG", "vertical field of view (30)",
     [](Description& d, Text where, Text text) {
       d.view.fov_deg = parse_number(where, text, fov_range_deg);
     }},
    {camera, "--ortho", "", "orthographic projection",
     [](Description& d, Text, Text) { d.view.projection = Projection::orthographic; }},
    {camera, "--height", "LENGTH", "what an orthographic picture spans (everything)",
     [](Description& d, Text where, Text text) {
       d.view.height = parse_number(where, text, any_length);
     }},
    {camera, "--viewer-at-infinity", "", "V is the same at every point",
     [](Description& d, Text, Text) { d.view.viewer_at_infinity = true; }},
    {picture, "--size", "WxH", "in pixels (960x720)", set_size},
    {picture, "--samples", "N", "per pixel, 1, 4, 8 or 16 (4)", set_samples},
    {picture, "--exposure", "EV", "each 1 more doubles the brightness (0)",
     [](Description& d, Text where, Text text) {
       d.picture.image.exposure_ev = parse_number(where, text, exposure_range_ev);
     }},
    {picture, "--encoding", "NAME", "srgb or linear, for 8-bit formats (srgb)",
     [](Description& d, Text where, Text text) {
       d.picture.image.encoding = choose(where, "encoding", text, encodings);
     }},
    {picture, "--interpolation", "NAME", "perspective, or screen-linear to see its error",
     set_interpolation},
    {picture, "--tolerance", "E", "skip what changes no pixel by more than E 8-bit steps (0)",
     [](Description& d, Text where, Text text) {
       d.picture.settings.tolerance = parse_number(where, text, {0, 255});
     }},
    {picture, "--clamp-vertex-colours", "", "Gouraud: clamp colours to 0..1 at the vertices",
     [](Description& d, Text, Text) { d.picture.settings.clamp_vertex_colours = true; }},
    {picture, "--threads", "N", "processors used (all)",
     [](Description& d, Text where, Text text) {
       d.picture.settings.threads = parse_integer(where, text, {1, 1024});
     }},
};

}  // namespace

void add_scene_options(CLI::App& app, SceneOptions& options) {
  app.add_option("INPUT", options.input, "mesh file, built-in shape (teapot:16) or scene (.toml)")
      ->type_name("")
      ->required();
  for (const Edit& edit : all_edits) {
    CLI::Option* option =
        *edit.type ? app.add_option(edit.option)->type_name(edit.type) : app.add_flag(edit.option);
    option->description(edit.help)->group(edit.group);
    options.edits.emplace_back(&edit, option);
  }
}

std::string switch_names() {
  std::string names;
  for (const SkipSwitch& skip : skip_switches())
    names += (names.empty() ? "" : ", ") + std::string(skip.name);
  return names;
}

void add_render_options(CLI::App& app, RenderOptions& options) {
  app.add_option("-o,--output", options.output, "picture; its suffix is its format (INPUT.png)")
      ->type_name("FILE");
  const auto add_repeatable = [&](const char* name, auto& values, const char* type,
                                  const char* help) {
    app.add_option(name, values, help)->type_name(type)->allow_extra_args(false);
  };
  add_repeatable("--aov", options.aovs, "WHAT",
                 "an EXR file of depth, normals, ids, parts of the light, cost; or: cost");
  app.add_flag("--stats", options.stats, "print times, what was skipped and what was done");
  add_repeatable("--skip-off", options.skips_off, "NAME", "do what no picture shows; see below");
  add_scene_options(app, options);
}

std::vector<GivenEdit> SceneOptions::given() const {
  std::vector<GivenEdit> given;
  for (const auto& [edit, option] : edits)
    if (option->count() > 0) given.push_back({edit, *edit->type ? option->as<std::string>() : ""});
  return given;
}

std::filesystem::path RenderOptions::output_file() const {
  if (!output.empty()) return output;
  const std::string base = is_shape(input) ? input.substr(0, input.find(':'))
                                           : std::filesystem::path(input).stem().string();
  return base + ".png";
}

bool RenderOptions::wants_cost_picture() const {
  return std::ranges::find(aovs, aov_cost) != aovs.end();
}

std::vector<std::filesystem::path> RenderOptions::aov_files() const {
  std::vector<std::filesystem::path> files(aovs.begin(), aovs.end());
  std::erase(files, aov_cost);
  return files;
}

Skips RenderOptions::skips() const {
  Skips skips;
  for (const std::string& name : skips_off) {
    const auto found = std::ranges::find(skip_switches(), name, &SkipSwitch::name);
    if (found == skip_switches().end())
      throw Error("--skip-off", "no switch '" + name + "'; there are: " + switch_names());
    skips.*found->member = false;
  }
  return skips;
}

bool is_scene(const std::string& input) {
  return !is_shape(input) && std::filesystem::path(input).extension() == ".toml";
}

Description describe(const std::string& input, std::span<const GivenEdit> edits,
                     std::span<const SceneChange> changes) {
  if (input.empty()) throw Error("INPUT", "the name is empty");
  Description description =
      is_scene(input) ? read_scene_file(input, changes) : describe_object(input);
  for (const GivenEdit& given : edits)
    given.edit->apply(description, given.edit->option, given.text);
  return description;
}

}  // namespace scanlit::studio
