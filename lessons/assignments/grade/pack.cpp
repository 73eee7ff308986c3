#include "lessons/assignments/grade/pack.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <vector>

#include "lessons/assignments/judge/files.h"
#include "lessons/assignments/judge/rubric.h"
#include "lessons/studio/pages/page.h"
#include "lessons/studio/tradeoff/temporary_folder.h"
#include "rasterizer/error.h"

extern char** environ;

namespace scanlit::assignments {
namespace fs = std::filesystem;
namespace {

/// Neither pictures nor what gives an assignment away.
bool is_packed(const fs::path& file) {
  if (file.extension() == ".png" || file.filename() == "wrong.toml") return false;
  for (const Assignment& each : assignments())
    if (file.filename() == each.file && file.parent_path().filename() == each.folder) return false;
  return true;
}

void copy_sources(const fs::path& source, const fs::path& target) {
  for (const char* name : {"CMakeLists.txt", "CMakePresets.json", "LICENSE"})
    fs::copy_file(source / name, target / name);
  for (const char* folder : {"rasterizer", "models", "lessons"}) {
    for (auto entry = fs::recursive_directory_iterator(source / folder);
         entry != fs::recursive_directory_iterator(); ++entry) {
      const fs::path within = fs::relative(entry->path(), source);
      if (within == "lessons/out") entry.disable_recursion_pending();
      if (!entry->is_regular_file() || !is_packed(entry->path())) continue;
      fs::create_directories((target / within).parent_path());
      fs::copy_file(entry->path(), target / within);
    }
  }
}

void copy_text(const fs::path& from, const fs::path& to, bool executable) {
  fs::copy_file(from, to);
  if (executable) fs::permissions(to, fs::perms(0755));
}

void check_rubric(const Assignment& assignment, const Pack& what) {
  Rubric rubric = read_rubric(what.rubric);
  if (rubric.assignment != assignment.id)
    throw Error(what.rubric.string(), "it is for " + rubric.assignment + ", not " + assignment.id);
  if (!what.hidden.empty()) add_hidden_tests(what.hidden, rubric);
}

/// By CMake, which knows how to write a zip, in the folder whose files are to be at its root.
void zip(const fs::path& folder, const fs::path& output) {
  const std::string file = fs::absolute(output).string();
  std::vector<std::string> words{"cmake", "-E", "chdir", folder.string(), "cmake", "-E",
                                 "tar",   "cf", file,    "--format=zip"};
  for (const auto& entry : fs::directory_iterator(folder))
    words.push_back(entry.path().filename().string());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, "cmake", nullptr, nullptr, argv.data(), environ) != 0)
    throw Error("packing wants cmake, which is not installed");
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(output.string(), "cannot be written");
}

}  // namespace

void pack(const Assignment& assignment, const Pack& what) {
  const fs::path data = data_folder(), source = data.parent_path().parent_path();
  if (!fs::exists(source / "CMakePresets.json"))
    throw Error("packing wants Scanlit's sources: call the program of a build tree");
  Pack full = what;
  if (full.rubric.empty()) full.rubric = data / assignment.folder / "rubric.toml";
  check_rubric(assignment, full);
  const studio::TemporaryFolder folder;
  const fs::path root = folder.file("autograder");
  fs::create_directories(root / "scanlit");
  copy_sources(source, root / "scanlit");
  for (const char* script : {"setup.sh", "run_autograder"})
    copy_text(data / "grade" / "gradescope" / script, root / script, true);
  copy_text(full.rubric, root / "rubric.toml", false);
  if (!full.hidden.empty()) {
    fs::create_directories(root / "hidden");
    const std::string name = assignment.id + ".toml";
    copy_text(full.hidden / name, root / "hidden" / name, false);
  }
  // Beside its place first: whoever packs again keeps the old one until the new one is whole.
  const fs::path fresh = full.output.string() + ".part";
  zip(root, fresh);
  fs::rename(fresh, full.output);
}

}  // namespace scanlit::assignments
