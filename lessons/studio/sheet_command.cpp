// scanlit sheet
#include <algorithm>
#include <iostream>
#include <memory>

#include "lessons/studio/commands.h"
#include "lessons/studio/description.h"
#include "lessons/studio/framing.h"
#include "lessons/studio/program.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "lessons/studio/text.h"
#include "models/materials.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"

namespace scanlit::studio {
namespace {

struct SheetOptions {
  std::vector<std::string> models;
  std::string output = "sheet.png", shape = "teapot:16", shading = "phong", cell = "260x190",
              columns;
};

/// A cell of the sheet: what stands under it, and what is drawn in it.
struct Cell {
  std::string label;
  models::NamedModel model;
};

std::vector<Cell> make_cells(const SheetOptions& options) {
  const std::string prefix = "material:";
  std::vector<std::string> specifications = options.models;
  if (specifications.empty())
    for (const models::NamedMaterial& material : models::materials())
      specifications.push_back(prefix + material.name);
  std::vector<Cell> cells;
  for (const std::string& specification : specifications) {
    const bool named = specification.starts_with(prefix);
    cells.push_back(
        {named ? specification.substr(prefix.size()) : specification, models::make(specification)});
  }
  return cells;
}

/// Every cell's object at the same place, so that one camera serves all.
Description describe(const SheetOptions& options, const std::vector<Cell>& cells) {
  Description description = describe_object(options.shape);
  std::tie(description.picture.width, description.picture.height) =
      parse_size("--size", options.cell);
  ObjectDescription object = description.objects[0];
  object.shading = choose("--shading", "shading", options.shading, shadings);
  description.objects.clear();
  for (const Cell& cell : cells) {
    object.material.model = cell.model;
    description.objects.push_back(object);
  }
  description.view.azimuth_deg = 20;
  description.view.elevation_deg = 22;
  description.view.fov_deg = 20;
  return description;
}

/// Four lights, placed by eye: a metal shows nothing but its highlights, and two are few. Over the
/// viewer's left shoulder, from the right, from behind, and from where the viewer is.
std::vector<Light> sheet_lights(const Camera& camera) {
  const glm::dmat3 axes = viewer_axes(camera);
  const auto light = [&](const glm::dvec3& direction, double intensity, const Rgb<double>& colour) {
    Light result;
    result.direction = axes * direction;
    result.intensity = intensity;
    result.colour = colour;
    return result;
  };
  return {light({-0.7, 0.7, 0.5}, 0.9, {1.0, 0.97, 0.92}),
          light({0.9, 0.15, 0.35}, 0.22, {0.7, 0.83, 1.0}), light({0.35, 0.8, -0.6}, 0.4, Rgb(1.0)),
          light({0.1, 0.25, 1.0}, 0.08, Rgb(1.0))};
}

/// The columns asked for, or about as many as make a sheet of 4:3.
int columns_of(const SheetOptions& options, const Picture& cell, int cells) {
  if (!options.columns.empty())
    return std::min(cells, parse_integer("--columns", options.columns, {1, 100}));
  int columns = 1;
  while (columns < cells && 3 * columns * cell.width < 4 * cell.height * cells / columns) ++columns;
  return columns;
}

Framebuffer draw_sheet(const Description& description, const std::vector<Cell>& cells,
                       int columns) {
  const Picture& cell = description.picture;
  const int count = int(cells.size()), rows = (count + columns - 1) / columns;
  const int size = std::clamp(cell.width / 20, 10, 24), line = size * 4 / 3;
  const int margin = size, row_height = cell.height + 2 * line + line / 2;
  const int width = 2 * margin + columns * cell.width, height = 2 * margin + rows * row_height;
  validate_size(width, height);

  const Scene all = make_scene(description);
  const Camera camera = make_camera(description.view, all, double(cell.width) / cell.height);
  Scene scene = all;
  scene.lights = sheet_lights(camera);
  Framebuffer sheet = blank_picture(width, height, description.background);
  Framebuffer framebuffer(cell.width, cell.height);
  const auto font = label_font();
  for (int i = 0; i < count; ++i) {
    scene.objects = {all.objects[std::size_t(i)]};
    render(scene, camera, cell.settings, framebuffer);
    const int x = margin + i % columns * cell.width, y = margin + i / columns * row_height;
    paste(framebuffer, sheet, x, y);
    if (!font) continue;
    const auto lines = two_lines(*font, cells[std::size_t(i)].label, size, cell.width - size);
    for (std::size_t k = 0; k < lines.size(); ++k)
      font->draw(sheet, x + cell.width / 2, y + cell.height + line * int(k + 1), lines[k], size,
                 Align::centre, Rgb<float>(0.75f));
  }
  return sheet;
}

void write_sheet(const SheetOptions& options) {
  check_image_target(options.output, 1, 1);
  const std::vector<Cell> cells = make_cells(options);
  const Description description = describe(options, cells);
  const int columns = columns_of(options, description.picture, int(cells.size()));
  const Framebuffer sheet = draw_sheet(description, cells, columns);
  const HoldInterrupts until_written;
  write_image(options.output, sheet);
  std::cout << options.output << ": " << sheet.width << " x " << sheet.height << " pixels, "
            << cells.size() << (cells.size() == 1 ? " material\n" : " materials\n");
}

}  // namespace

Command add_sheet_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("sheet", "Draws a contact sheet of materials");
  app->footer(
      "Examples:\n"
      "  scanlit sheet -o materials.png\n"
      "  scanlit sheet phong:n=5 phong:n=20 phong:n=100 --columns 3 -o exponents.png\n"
      "\n"
      "In brackets: defaults. Labels need a font; Debian's package fonts-dejavu-core has one.");
  const auto options = std::make_shared<SheetOptions>();
  app->add_option("MODEL", options->models, "reflection models or material:NAME (all there are)")
      ->type_name("");
  app->add_option("-o,--output", options->output, "picture; its suffix is its format (sheet.png)")
      ->type_name("FILE");
  app->add_option("--shape", options->shape, "what wears the materials, shape or mesh (teapot:16)")
      ->type_name("MESH");
  app->add_option("--shading", options->shading, "flat, gouraud or phong (phong)")
      ->type_name("MODE");
  app->add_option("--size", options->cell, "of one picture, in pixels (260x190)")->type_name("WxH");
  app->add_option("--columns", options->columns, "pictures side by side (a sheet of about 4:3)")
      ->type_name("N");
  return {app, [options] { write_sheet(*options); }};
}

}  // namespace scanlit::studio
