// What every lesson does around its one new idea: --help, --size, -o, errors, writing the picture.
#pragma once

#include <functional>
#include <string>

#include "rasterizer/framebuffer.h"

namespace scanlit::studio {

struct Lesson {
  std::string idea;     // one line, for --help
  std::string picture;  // file, unless -o names another; its folder is made if it is not there
  int width, height;    // pixels, unless --size says otherwise
  std::function<Framebuffer(int width, int height)> draw;
};

/// A lesson's main(): draws, writes, says where the picture is. Returns the exit code.
int run_lesson(int argc, char** argv, const Lesson& lesson);

}  // namespace scanlit::studio
