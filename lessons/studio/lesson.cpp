#include "lessons/studio/lesson.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <tuple>

#include "rasterizer/image.h"

namespace scanlit::studio {

Lesson::Lesson(std::string idea, int width, int height)
    : idea_(std::move(idea)), width_(width), height_(height) {}

void Lesson::knob(const std::string& option, const std::string& shown, const std::string& what,
                  const std::function<void(const std::string& text)>& read) {
  knobs_.push_back({option, what + " (" + shown + ")", shown, read});
}

void Lesson::knob(const std::string& option, int& value, const Range& range,
                  const std::string& what) {
  knob(option, std::to_string(value), what, [option, &value, range](const std::string& text) {
    value = parse_integer(option, text, range);
  });
}

void Lesson::knob(const std::string& option, double& value, const Range& range,
                  const std::string& what) {
  knob(option, text_of(value), what, [option, &value, range](const std::string& text) {
    value = parse_number(option, text, range);
  });
}

void Lesson::knob(const std::string& option, std::string& value, const std::string& what) {
  knob(option, value, what, [&value](const std::string& text) { value = text; });
}

/// "WxH", or the width alone: the height keeps the lesson's proportions.
void Lesson::read_size(const std::string& text) {
  if (text.find('x') != std::string::npos) {
    std::tie(width_, height_) = parse_size("--size", text);
    return;
  }
  const int width = parse_integer("--size", text, {1, max_framebuffer_size});
  height_ = std::max(1, int(std::lround(double(width) * height_ / width_)));
  width_ = width;
  validate_size(width_, height_);
}

void Lesson::figure(const std::string& name, const std::string& value) {
  figures_ += name + ": " + value + '\n';
}

void Lesson::time(const std::string& name, double milliseconds) {
  figure(name, fixed(milliseconds, 1) + " ms");
}

void Lesson::finish(const std::string& output, const std::function<Framebuffer()>& draw) {
  std::filesystem::path file = output;
  if (output.empty()) {
    file = std::filesystem::path(SCANLIT_LESSONS_OUT) / (name_ + ".png");
    std::filesystem::create_directories(file.parent_path());
  }
  check_image_target(file, width_, height_);
  const Framebuffer picture = draw();
  const HoldInterrupts until_written;
  write_image(file, picture);
  std::cout << figures_ << file.string() << ": " << picture.width << " x " << picture.height
            << " pixels\n";
}

int Lesson::run(int argc, char** argv, const std::function<Framebuffer()>& draw) {
  name_ = std::filesystem::path(argv[0]).filename().string();
  return run_program(name_, argc, argv, [&](CLI::App& app) {
    struct Options {
      std::string size, output;
    };
    const auto options = std::make_shared<Options>();
    app.description(idea_);
    app.add_option("-o,--output", options->output, "picture (lessons/out/" + name_ + ".png)")
        ->type_name("FILE");
    app.add_option("--size", options->size,
                   "in pixels, or the width alone (" + std::to_string(width_) + 'x' +
                       std::to_string(height_) + ")")
        ->type_name("WxH");
    for (Knob& each : knobs_) app.add_option(each.option, each.text, each.what)->type_name("");
    std::string example = name_ + " --size 600 -o small.png";
    if (!knobs_.empty()) example += "\n  " + name_ + ' ' + knobs_[0].option + ' ' + knobs_[0].shown;
    app.footer("Examples:\n  " + example);
    return [this, options, &app, &draw] {
      if (!options->size.empty()) read_size(options->size);
      for (const Knob& each : knobs_)
        if (app.count(each.option) > 0) each.read(each.text);
      finish(options->output, draw);
    };
  });
}

}  // namespace scanlit::studio
