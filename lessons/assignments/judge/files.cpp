#include "lessons/assignments/judge/files.h"

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

std::vector<Made> support_files(const Assignment& assignment, std::uint64_t seed) {
  const fs::path folder = data_folder() / assignment.folder;
  std::vector<Made> all{{"variant.h", fill_in(studio::read_text(folder / "variant.h"),
                                              assignment.words(seed), "variant.h")}};
  for (const std::string& name : {assignment.header, std::string("main.cpp")})
    all.push_back({name, studio::read_text(folder / name)});
  for (const char* name : {"answer/protocol.h", "answer/serve.h"})
    all.push_back({name, studio::read_text(data_folder() / name)});
  return all;
}

Made starter(const Assignment& assignment) {
  const fs::path folder = data_folder() / assignment.folder;
  if (fs::exists(folder / "starter.cpp"))
    return {assignment.file, studio::read_text(folder / "starter.cpp")};
  return {assignment.file, strip(studio::read_text(folder / assignment.file), assignment.file)};
}

Made solution(const Assignment& assignment) {
  const fs::path file = data_folder() / assignment.folder / assignment.file;
  if (!fs::exists(file)) throw Error("the solutions are not installed");
  return {assignment.file, studio::read_text(file)};
}

}  // namespace scanlit::assignments
