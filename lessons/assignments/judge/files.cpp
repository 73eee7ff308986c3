#include "lessons/assignments/judge/files.h"

#include <fstream>

#include "lessons/assignments/judge/strip.h"
#include "lessons/studio/pages/page.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {

namespace fs = std::filesystem;

fs::path data_folder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path() / "../share/scanlit/assignments";
  if (fs::is_directory(installed, none)) return fs::canonical(installed);
  if (fs::is_directory(SCANLIT_ASSIGNMENTS, none)) return SCANLIT_ASSIGNMENTS;
  throw Error("the assignments' files are not installed: there is no " +
              installed.lexically_normal().string());
}

namespace {

/// What formulas are written in: the engine's own headers, of which none holds a model, and which
/// need no library.
void add_vocabulary(std::vector<Made>& all) {
  const fs::path answer = data_folder() / "answer", installed = data_folder() / "rasterizer";
  all.push_back({"answer/model.h", studio::read_text(answer / "model.h")});
  const auto add = [&](const char* name, const fs::path& in_the_source) {
    const fs::path folder = fs::is_directory(installed) ? installed : in_the_source;
    all.push_back({std::string("rasterizer/") + name, studio::read_text(folder / name)});
  };
  for (const char* name : {"batch.h", "batch_trigonometry.h"}) add(name, answer / "rasterizer");
  for (const char* name :
       {"cosines.h", "light_source.h", "reflection_model.h", "scalar_math.h", "vec.h"})
    add(name, data_folder() / "../../rasterizer");
}

}  // namespace

std::vector<Made> support_files(const Assignment& assignment, std::uint64_t seed) {
  const fs::path folder = data_folder() / assignment.folder;
  std::vector<Made> all{{"variant.h", fill_in(studio::read_text(folder / "variant.h"),
                                              assignment.words(seed), "variant.h")}};
  for (const std::string& name :
       {assignment.header, std::string("questions.h"), std::string("main.cpp")})
    if (!name.empty()) all.push_back({name, studio::read_text(folder / name)});
  for (const char* name : {"answer/protocol.h", "answer/serve.h"})
    all.push_back({name, studio::read_text(data_folder() / name)});
  if (assignment.is_model()) add_vocabulary(all);
  return all;
}

Made starter(const Assignment& assignment) {
  const fs::path folder = data_folder() / assignment.folder;
  const fs::path stripped = folder / ("starter" + fs::path(assignment.file).extension().string());
  if (fs::exists(stripped)) return {assignment.file, studio::read_text(stripped)};
  return {assignment.file, strip(studio::read_text(folder / assignment.file), assignment.file)};
}

Made solution(const Assignment& assignment) {
  const fs::path file = data_folder() / assignment.folder / assignment.file;
  if (!fs::exists(file)) throw Error("the solutions are not installed");
  return {assignment.file, studio::read_text(file)};
}

// ------------------------------------------------------------------------------- what is installed

namespace {

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << text).flush()) throw Error(file.string(), "cannot be written");
}

void copy(const Assignment& assignment, const std::string& name, const fs::path& folder) {
  const fs::path within = fs::path(assignment.folder) / name;
  write(folder / within, studio::read_text(data_folder() / within));
}

}  // namespace

void write_course(const fs::path& folder) {
  for (const Assignment& each : assignments()) {
    for (const char* name : {"page.md", "variant.h", "questions.h", "main.cpp", "rubric.toml"})
      copy(each, name, folder);
    if (!each.header.empty()) copy(each, each.header, folder);
    write(folder / each.folder / ("starter" + fs::path(each.file).extension().string()),
          starter(each).text);
    // What all share (answer/), and what of the engine they may see (rasterizer/).
    for (const Made& made : support_files(each, 1))
      if (fs::path(made.name).has_parent_path()) write(folder / made.name, made.text);
  }
}

void write_solutions(const fs::path& folder) {
  for (const Assignment& each : assignments())
    for (const std::string& name : {each.file, std::string("wrong.toml")}) copy(each, name, folder);
}

}  // namespace scanlit::assignments
