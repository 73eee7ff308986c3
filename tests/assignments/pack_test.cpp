// What is in an autograder, and what is not.
#include "lessons/assignments/grade/pack.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "lessons/studio/pages/page.h"
#include "lessons/studio/tradeoff/temporary_folder.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {
namespace {

namespace fs = std::filesystem;

bool runs(const std::string& command) { return std::system(command.c_str()) == 0; }

bool is_executable(const fs::path& file) {
  return (fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

TEST(Pack, HoldsTheJudgeAndNoSolution) {
  const studio::TemporaryFolder folder;
  const fs::path hidden = folder.file("hidden");
  fs::create_directories(hidden);
  std::ofstream(hidden / "A1.toml")
      << "assignment = \"A1\"\n[[test]]\nid = \"H1\"\npart = \"A1.2\"\npoints = 5\n";
  pack(assignment("A1"), {.rubric = {}, .hidden = hidden, .output = folder.file("a.zip")});
  const fs::path root = folder.file("root");
  fs::create_directories(root);
  ASSERT_TRUE(runs("cd '" + root.string() + "' && cmake -E tar xf ../a.zip"));
  EXPECT_TRUE(is_executable(root / "setup.sh"));
  EXPECT_TRUE(is_executable(root / "run_autograder"));
  EXPECT_TRUE(fs::exists(root / "hidden/A1.toml"));
  for (const Assignment& each : assignments()) {
    const fs::path data = root / "scanlit/lessons/assignments" / each.folder;
    EXPECT_TRUE(fs::exists(data / "main.cpp")) << each.id;
    EXPECT_FALSE(fs::exists(data / each.file)) << each.id;
    EXPECT_FALSE(fs::exists(data / "wrong.toml")) << each.id;
  }

  // Whatever goes wrong, Gradescope gets a results.json: here nothing is built.
  fs::create_directories(folder.file("autograder/submission"));
  fs::rename(root, folder.file("autograder/source"));
  EXPECT_TRUE(runs("SCANLIT_AUTOGRADER='" + std::string(folder.file("autograder")) + "' '" +
                   folder.file("autograder/source/run_autograder") + "' 2> /dev/null"));
  EXPECT_NE(studio::read_text(folder.file("autograder/results/results.json")).find("\"tests\""),
            std::string::npos);
}

TEST(Pack, RefusesTheRubricOfAnother) {
  const studio::TemporaryFolder folder;
  std::ofstream(folder.file("rubric.toml")) << "assignment = \"A2\"\n";
  EXPECT_THROW(
      pack(assignment("A1"),
           {.rubric = folder.file("rubric.toml"), .hidden = {}, .output = folder.file("a.zip")}),
      Error);
  EXPECT_FALSE(fs::exists(folder.file("a.zip")));
}

}  // namespace
}  // namespace scanlit::assignments
