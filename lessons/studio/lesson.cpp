#include "lessons/studio/lesson.h"

#include <filesystem>
#include <iostream>
#include <tuple>

#include "lessons/studio/program.h"
#include "lessons/studio/text.h"
#include "rasterizer/image.h"

namespace scanlit::studio {

int run_lesson(int argc, char** argv, const Lesson& lesson) {
  const std::string program = std::filesystem::path(argv[0]).filename().string();
  CLI::App app(lesson.idea, program);
  std::string size, output;
  app.add_option("-o,--output", output, "picture (" + lesson.picture + ")")->type_name("FILE");
  app.add_option("--size", size, "in pixels")->type_name("WxH");
  app.footer("Example:\n  " + program + " --size 900x300 -o small.png");

  return run_program(app, argc, argv, [&] {
    auto [width, height] = std::pair(lesson.width, lesson.height);
    if (!size.empty()) std::tie(width, height) = parse_size("--size", size);
    if (output.empty()) {
      output = lesson.picture;
      std::filesystem::create_directories(std::filesystem::path(output).parent_path());
    }
    check_image_target(output, width, height);
    const Framebuffer framebuffer = lesson.draw(width, height);
    const HoldInterrupts until_written;
    write_image(output, framebuffer);
    std::cout << output << ": " << width << " x " << height << " pixels\n";
  });
}

}  // namespace scanlit::studio
