#include "lessons/studio/scene_file.h"

#include <algorithm>
#include <fstream>

#include "lessons/studio/scene_sections.h"

namespace scanlit::studio {

const char* const scene_example =
    "  [camera]\n"
    "  azimuth = 30                                  # the rest is framed automatically\n"
    "  [material.copper]\n"
    "  model = \"blinn-phong:kd=.6/.3/.2,ks=.5,n=80\"  # scanlit models\n"
    "  [[object]]\n"
    "  mesh = \"teapot:16\"                            # scanlit shapes, or a file next to this "
    "one\n"
    "  material = \"copper\"\n"
    "  rotate = { axis = [0, 1, 0], angle = 20 }";

namespace {

void read_camera(TomlTable table, View& view) {
  view.eye = table.vector("eye");
  view.target = table.vector("target");
  set(view.up, table.vector("up"));
  const auto azimuth_deg = table.number("azimuth", any_angle_deg);
  const auto elevation_deg = table.number("elevation", elevation_range_deg);
  if (view.eye && (azimuth_deg || elevation_deg))
    table.refuse(azimuth_deg ? "azimuth" : "elevation",
                 "eye already says where the viewer is; keep one of them");
  set(view.azimuth_deg, azimuth_deg);
  set(view.elevation_deg, elevation_deg);
  set(view.projection, table.choice("projection", projections));
  set(view.fov_deg, table.number("fov", fov_range_deg));
  view.height = table.number("height", any_length);
  view.near = table.number("near", any_coordinate);
  view.far = table.number("far", any_coordinate);
  set(view.viewer_at_infinity, table.boolean("viewer_at_infinity"));
  table.refuse_unknown_keys();
}

void read_picture(TomlTable table, Picture& picture) {
  const Range side{1, max_framebuffer_size};
  set(picture.width, table.integer("width", side));
  set(picture.height, table.integer("height", side));
  if (const auto samples = table.integer("samples", {1, 16}))
    picture.settings.samples = check_samples(table.where("samples"), *samples);
  set(picture.image.exposure_ev, table.number("exposure", exposure_range_ev));
  table.refuse_unknown_keys();
}

void read_ambient(TomlTable table, Description& description) {
  set(description.ambient_intensity, table.number("intensity", light_range));
  set(description.ambient_colour, table.colour("colour", light_range));
  table.refuse_unknown_keys();
}

void read_background(TomlTable table, Description& description) {
  set(description.background, table.colour("colour", light_range));
  table.refuse_unknown_keys();
}

Materials read_materials(TomlTable table, const std::filesystem::path& folder) {
  Materials materials;
  for (const std::string& name : table.keys())
    materials[name] = read_material(*table.table(name.c_str(), "[material." + name + ']'), folder);
  return materials;
}

Description read_root(TomlTable root, const std::filesystem::path& folder) {
  Description description;
  if (auto table = root.table("camera", "[camera]")) read_camera(*table, description.view);
  if (auto table = root.table("picture", "[picture]")) read_picture(*table, description.picture);
  if (auto table = root.table("ambient", "[ambient]")) read_ambient(*table, description);
  if (auto table = root.table("background", "[background]")) read_background(*table, description);
  for (const TomlTable& table : root.tables("light"))
    description.lights.push_back(read_light(table));
  Materials materials;
  if (auto table = root.table("material", "[material]")) materials = read_materials(*table, folder);
  for (const TomlTable& table : root.tables("object"))
    description.objects.push_back(read_object(table, materials, folder));
  root.refuse_unknown_keys();
  if (description.objects.empty())
    throw Error(root.where(), "no [[object]]; a scene needs at least one");
  return description;
}

/// toml++ limits the depth of values but not of dotted keys, and takes them apart by recursion:
/// from some 50,000 dots in a key on, the stack overflows.
void refuse_deep_keys(std::string_view text, const std::string& file) {
  constexpr std::ptrdiff_t max_dots = 20'000;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    if (std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '.') > max_dots)
      throw Error(file + ':' + std::to_string(line), "more than 20000 dots in one line");
    text.remove_prefix(end + 1);
  }
}

std::string read_text(const std::filesystem::path& file) {
  constexpr std::uintmax_t max_bytes = 64 << 20;
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) throw Error(file.string(), "there is no such file");
  // A pipe or device might never end.
  if (!std::filesystem::is_regular_file(file)) throw Error(file.string(), "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (size > max_bytes) throw Error(file.string(), "larger than 64 MiB, which no scene is");
  std::string text(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), std::streamsize(size)))
    throw Error(file.string(), "cannot be read");
  return text;
}

}  // namespace

Description read_scene(std::string_view text, const std::filesystem::path& file,
                       std::span<const SceneChange> changes) {
  refuse_deep_keys(text, file.string());
  try {
    toml::table root = toml::parse(text, file.string());
    for (const SceneChange& change : changes) apply(change, root);
    return read_root(TomlTable(root, file.string(), "the scene"), file.parent_path());
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw Error(file.string() + ':' + std::to_string(at.line) + ':' + std::to_string(at.column),
                std::string(error.description()));
  }
}

Description read_scene_file(const std::filesystem::path& file,
                            std::span<const SceneChange> changes) {
  return read_scene(read_text(file), file, changes);
}

}  // namespace scanlit::studio
