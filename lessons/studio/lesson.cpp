#include "lessons/studio/lesson.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <tuple>

#include "lessons/studio/program.h"
#include "lessons/studio/text.h"
#include "rasterizer/image.h"

namespace scanlit::studio {
namespace {

struct Options {
  std::string size, output;
};

void draw_lesson(const Lesson& lesson, const Options& options) {
  auto [width, height] = std::pair(lesson.width, lesson.height);
  if (!options.size.empty()) std::tie(width, height) = parse_size("--size", options.size);
  const std::filesystem::path output = options.output.empty() ? lesson.picture : options.output;
  if (options.output.empty()) std::filesystem::create_directories(output.parent_path());
  check_image_target(output, width, height);
  const Framebuffer framebuffer = lesson.draw(width, height);
  const HoldInterrupts until_written;
  write_image(output, framebuffer);
  std::cout << output.string() << ": " << width << " x " << height << " pixels\n";
}

}  // namespace

int run_lesson(int argc, char** argv, const Lesson& lesson) {
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  return run_program(name, argc, argv, [&](CLI::App& app) {
    const auto options = std::make_shared<Options>();
    const std::string size = std::to_string(lesson.width) + 'x' + std::to_string(lesson.height);
    app.description(lesson.idea);
    app.add_option("-o,--output", options->output, "picture (" + lesson.picture + ")")
        ->type_name("FILE");
    app.add_option("--size", options->size, "in pixels (" + size + ")")->type_name("WxH");
    app.footer("Example:\n  " + name + " --size 900x250 -o small.png");
    return [&lesson, options] { draw_lesson(lesson, *options); };
  });
}

}  // namespace scanlit::studio
