// scanlit watch
#include <algorithm>
#include <iostream>
#include <memory>

#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "lessons/studio/progress_bar.h"
#include "lessons/studio/render_options.h"
#include "lessons/studio/split.h"
#include "lessons/studio/text.h"
#include "lessons/studio/watch/example.h"
#include "lessons/studio/watch/moments.h"
#include "lessons/studio/watch/scan_picture.h"
#include "rasterizer/error.h"
#include "rasterizer/image/animation.h"

namespace scanlit::studio {
namespace {

struct WatchOptions : SceneOptions {
  std::string output, region, cell = "24", fps = "4";
};

constexpr int most_columns = 96, most_rows = 64;

/// "X,Y,W,H"; without it, 32 x 18 pixels in the middle.
Rect parse_region(const std::string& text, const Picture& picture) {
  if (text.empty()) {
    const int columns = std::min(32, picture.width), rows = std::min(18, picture.height);
    const int x = (picture.width - columns) / 2, y = (picture.height - rows) / 2;
    return {x, y, x + columns, y + rows};
  }
  std::vector<int> numbers;
  for (const std::string_view number : split(text, ','))
    numbers.push_back(parse_integer("--region", number, {0, double(max_framebuffer_size)}));
  if (numbers.size() != 4)
    throw Error("--region", "'" + text + "' is not X,Y,W,H: the top left pixel, and how many");
  const Rect region{numbers[0], numbers[1], numbers[0] + numbers[2], numbers[1] + numbers[3]};
  if (numbers[2] < 1 || numbers[2] > most_columns || numbers[3] < 1 || numbers[3] > most_rows)
    throw Error("--region", "1 to " + std::to_string(most_columns) + " columns and 1 to " +
                                std::to_string(most_rows) + " rows can be magnified, not " +
                                std::to_string(numbers[2]) + " x " + std::to_string(numbers[3]));
  if (region.x_end > picture.width || region.y_end > picture.height)
    throw Error("--region", "'" + text + "' reaches beyond the picture of " +
                                std::to_string(picture.width) + " x " +
                                std::to_string(picture.height) + " pixels");
  return region;
}

ScanStory story_of(const WatchOptions& options) {
  if (options.input.empty()) {
    const WatchExample example = watch_example();
    return watch_scan_conversion(example.scene, example.camera, {}, example.width, example.height,
                                 {0, 0, example.width, example.height});
  }
  const Description description = describe(options.input, options.given());
  const Picture& picture = description.picture;
  const Rect region = parse_region(options.region, picture);
  const auto [scene, camera] = make_scene_and_camera(description);
  return watch_scan_conversion(scene, camera, picture.settings, picture.width, picture.height,
                               region);
}

void watch(const WatchOptions& options) {
  const int cell = parse_integer("--cell", options.cell, {8, 64});
  const double fps =
      parse_number("--fps", options.fps, {min_frames_per_second, max_frames_per_second});
  if (options.input.empty() && (!options.region.empty() || !options.given().empty()))
    throw Error("INPUT", "is missing: the example without one has no options of a scene");
  check_animation(options.output, 1, 1, 1);
  const ScanStory story = story_of(options);
  if (story.triangles.empty()) throw Error("--region", "no triangle covers a pixel there");
  const std::vector<Moment> moments = moments_of(story, fps);
  if (story.triangles.size() > most_moments)
    throw Error("--region", grouped(std::int64_t(story.triangles.size())) +
                                " triangles are too many to watch there; " +
                                std::to_string(most_moments) + " are the most");
  const ScanPictureSize size = scan_picture_size(story.part, cell);
  check_animation(options.output, size.width, size.height, int(moments.size()));

  ProgressBar bar;
  const HoldInterrupts until_written;
  write_animation(
      options.output, int(moments.size()),
      [&](int i) {
        bar.show(double(i) / double(moments.size()));
        return scan_picture(story, moments[std::size_t(i)], cell);
      },
      fps);
  std::cout << options.output << ": " << moments.size() << " frames, " << story.triangles.size()
            << " triangles on " << story.part.x_end - story.part.x_begin << " x "
            << story.part.y_end - story.part.y_begin << " pixels\n";
}

}  // namespace

Command add_watch_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("watch", "Animates scan conversion, pixel by pixel");
  app->footer(
      "Examples:\n"
      "  scanlit watch -o triangles.gif\n"
      "  scanlit watch cube --size 40x24 -o cube.gif\n"
      "  scanlit watch teapot:16 --region 470,280,32,18 -o spout.gif\n"
      "\n"
      "Without INPUT three triangles: two that share an edge, a third one through them. Edges,\n"
      "the active scanline, the span's ends, centres exactly on an edge, the depth test: each row\n"
      "of each triangle, in the order in which the engine draws them, with one sample a pixel.");
  const auto options = std::make_shared<WatchOptions>();
  app->add_option("-o,--output", options->output, "the animation, a .gif file")
      ->type_name("FILE")
      ->required();
  app->add_option("--region", options->region,
                  "pixels that are magnified (32,18 in the picture's middle)")
      ->type_name("X,Y,W,H");
  app->add_option("--cell", options->cell, "side of a magnified pixel (24)")->type_name("N");
  app->add_option("--fps", options->fps, "rows a second, 1 to 50 (4)")->type_name("N");
  add_scene_options(*app, *options);
  app->get_option("INPUT")->required(false);
  return {app, [options] { watch(*options); }};
}

}  // namespace scanlit::studio
