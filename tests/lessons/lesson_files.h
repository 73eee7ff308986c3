// Where the lessons are.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "lessons/studio/pages/page.h"

namespace scanlit::test {

inline std::filesystem::path lessons_folder() { return SCANLIT_SOURCE_DIR "/lessons"; }

inline std::vector<std::string> all_lessons() { return studio::lesson_names(lessons_folder()); }

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace scanlit::test
