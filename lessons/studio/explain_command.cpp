// scanlit explain
#include <algorithm>
#include <cstring>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "lessons/studio/commands.h"
#include "lessons/studio/explain/explanation.h"
#include "lessons/studio/render_options.h"
#include "lessons/studio/split.h"
#include "lessons/studio/text.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

struct ExplainOptions : SceneOptions {
  std::string pixel, fragment;
  bool json = false;
};

std::pair<int, int> parse_pixel(const std::string& text, const Picture& picture) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 2)
    throw Error("--pixel", "'" + text + "' is not X,Y: a column and a row, such as 480,360");
  return {parse_integer("--pixel", parts[0], {0, double(picture.width - 1)}),
          parse_integer("--pixel", parts[1], {0, double(picture.height - 1)})};
}

/// The one asked for, else the one with the greatest share of the pixel.
std::size_t choose_fragment(const ExplainOptions& options, const PixelRecord& record) {
  const auto& fragments = record.fragments;
  const int count = int(fragments.size());
  if (!options.fragment.empty() && count == 0)
    throw Error("--fragment", "the pixel has none: it shows the background");
  if (!options.fragment.empty())
    return std::size_t(parse_integer("--fragment", options.fragment, {0, double(count - 1)}));
  return std::size_t(std::ranges::max_element(fragments, {}, &FragmentRecord::weight) -
                     fragments.begin());
}

void explain(const ExplainOptions& options) {
  const Description description = describe(options.input, options.given());
  const Picture& picture = description.picture;
  const auto [x, y] = parse_pixel(options.pixel, picture);
  const auto [scene, camera] = make_scene_and_camera(description);

  const Explanation explanation{
      options.input, description, scene,
      record_pixel(scene, camera, picture.settings, picture.width, picture.height, x, y)};
  const PixelRecord& record = explanation.record;
  if (std::memcmp(record.colour, record.drawn, sizeof record.drawn) != 0)
    throw std::logic_error("the derivation of pixel " + options.pixel +
                           " does not give the picture's floats");
  const std::size_t fragment = choose_fragment(options, record);
  if (options.json)
    print_explanation_json(std::cout, explanation);
  else
    print_explanation(std::cout, explanation, fragment);
}

}  // namespace

Command add_explain_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("explain", "Derives one pixel, step by step");
  app->footer(
      "Examples:\n"
      "  scanlit explain teapot:16 --pixel 480,360\n"
      "  scanlit explain scene.toml --pixel 480,360 --samples 1 --shading gouraud\n"
      "  scanlit explain teapot:16 --pixel 480,360 --model cook-torrance --json\n"
      "\n"
      "Which triangle the pixel shows and which it hides, N, L, V and H, every term of the\n"
      "reflection model, each light's share, and the pixel's value: the engine's own numbers, as\n"
      "scanlit render draws it with the same options; D, G and F are evaluated again in double.");
  const auto options = std::make_shared<ExplainOptions>();
  app->add_option("--pixel", options->pixel, "column and row, from 0,0 at the top left")
      ->type_name("X,Y")
      ->required();
  app->add_option("--fragment", options->fragment,
                  "of several triangles in the pixel (that with most samples)")
      ->type_name("K");
  app->add_flag("--json", options->json, "all fragments as JSON, with all digits");
  add_scene_options(*app, *options);
  return {app, [options] { explain(*options); }};
}

}  // namespace scanlit::studio
