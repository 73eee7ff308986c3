#include "lessons/assignments/judge/handout.h"

#include <fstream>

#include "lessons/assignments/judge/files.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/program.h"
#include "lessons/assignments/judge/strip.h"
#include "lessons/studio/pages/page.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"

namespace scanlit::assignments {

namespace fs = std::filesystem;

namespace {

/// Builds the program without the judge: for an editor that wants to know the compiler's words.
std::string cmake_lists(const Assignment& assignment) {
  std::string flags;
  for (const std::string& flag : compiler_flags()) flags += " " + flag;
  return "# For your editor. `scanlit check .` builds by itself, with the same flags.\n"
         "cmake_minimum_required(VERSION 3.24)\n"
         "project(" +
         assignment.id +
         " LANGUAGES CXX)\n"
         "add_executable(answers " +
         (assignment.is_model() ? "" : assignment.file + " ") +
         "main.cpp)\n"
         "target_include_directories(answers PRIVATE .)\n"
         "target_compile_options(answers PRIVATE" +
         flags + ")\n";
}

constexpr const char* cmake_presets = R"({
  "version": 5,
  "configurePresets": [
    {"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build"}
  ],
  "buildPresets": [{"name": "release", "configurePreset": "release"}]
}
)";

/// The rubric with this seed in place of its own.
std::string seeded_rubric(const Assignment& assignment, std::uint64_t seed) {
  std::string text = studio::read_text(data_folder() / assignment.folder / "rubric.toml");
  const std::size_t begin = text.find("\nseed = ") + 1;
  if (begin == 0) throw Error("rubric.toml", "it has no line 'seed = ...'");
  return text.replace(begin, text.find('\n', begin) - begin, "seed = " + std::to_string(seed));
}

void write(const fs::path& folder, const Made& made) {
  const fs::path file = folder / made.name;
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << made.text).flush()) throw Error(file.string(), "cannot be written");
}

void fill(const Assignment& assignment, std::uint64_t seed, const fs::path& folder) {
  const std::string page = studio::read_text(data_folder() / assignment.folder / "page.md");
  Words words = assignment.words(seed);
  words["seed"] = std::to_string(seed);
  write(folder, {"README.md", fill_in(page, words, "page.md")});
  write(folder, {"rubric.toml", seeded_rubric(assignment, seed)});
  write(folder, {"CMakeLists.txt", cmake_lists(assignment)});
  write(folder, {"CMakePresets.json", cmake_presets});
  write(folder, starter(assignment));
  for (const Made& made : support_files(assignment, seed)) write(folder, made);
  for (const auto& [name, picture] : assignment.illustrations(seed))
    write_image(folder / name, picture_of(picture.width, picture.height, picture.fresh));
}

}  // namespace

void hand_out(const Assignment& assignment, std::uint64_t seed, const fs::path& folder) {
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw Error(folder.string(), "there is something already");
  const bool there = fs::exists(folder);
  try {
    fs::create_directories(folder);
    fill(assignment, seed, folder);
  } catch (...) {
    for (const auto& entry : fs::directory_iterator(folder)) fs::remove_all(entry);
    if (!there) fs::remove(folder);
    throw;
  }
}

}  // namespace scanlit::assignments
