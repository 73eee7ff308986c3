// scanlit frames in several processes: ranges, tasks of a Slurm array job, ranks under MPI.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

const std::string command = "frames teapot:3 --size 60x45 --count 7 -o ";

void expect_same_frames(const Folder& folder, int count, const std::string& a,
                        const std::string& b) {
  for (int i = 0; i < count; ++i) {
    const std::string name =
        "/frame_00" + std::string(i < 10 ? "0" : "") + std::to_string(i) + ".png";
    EXPECT_FALSE(folder.read(a + name).empty()) << a + name;
    EXPECT_EQ(folder.read(a + name), folder.read(b + name)) << name;
  }
}

TEST(FramesRanks, RangesMakeTheWhole) {
  const Folder folder;
  folder.run(command + "all");
  EXPECT_EQ(folder.run(command + "parts --range 0:2").out,
            "parts: 3 of 7 frames, 3 drawn, 0 kept\n");
  folder.run(command + "parts --range 3:3");
  folder.run(command + "parts --range 4:6");
  expect_same_frames(folder, 7, "all", "parts");
}

TEST(FramesRanks, TasksOfAnArrayJobMakeTheWhole) {
  const Folder folder;
  folder.run(command + "all");
  int drawn = 0;
  for (const char* id : {"5", "7", "9"}) {
    const Outcome outcome = folder.run(
        command + "tasks --slurm", std::string("SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=5 "
                                               "SLURM_ARRAY_TASK_STEP=2 SLURM_ARRAY_TASK_ID=") +
                                       id);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    drawn += std::atoi(outcome.out.substr(7).c_str());
  }
  EXPECT_EQ(drawn, 7) << "none twice";
  expect_same_frames(folder, 7, "all", "tasks");
}

TEST(FramesRanks, AnArrayWithGapsIsRefused) {
  const Folder folder;
  const auto task = [&](const std::string& environment) {
    return folder.run(command + "d --slurm", environment);
  };
  expect_refusal(task("SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_ID=9"),
                 "the array has gaps");
  expect_refusal(task("SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_ID=x"), "SLURM_ARRAY_TASK_ID");
  expect_refusal(folder.run(command + "d --slurm --force"), "--force");
  EXPECT_EQ(folder.files(), std::vector<std::string>{});
}

// As root in a container, and with more ranks than processors. Open MPI itself leaks.
const std::string mpirun =
    "ASAN_OPTIONS=detect_leaks=0 mpirun -n 2 --allow-run-as-root --oversubscribe ";

/// Why nothing can be tried under MPI; empty where it can.
std::string missing() {
  if (std::system("command -v mpirun >/dev/null") != 0)
    return "mpirun is not installed (Debian: openmpi-bin)";
  if (contains(Folder().run(command + "d", mpirun).err, "built without MPI"))
    return "scanlit was built without MPI (Debian: libopenmpi-dev)";
  return "";
}

TEST(FramesRanks, UnderMpiTheyDrawWhatOneProcessDraws) {
  if (const std::string reason = missing(); !reason.empty()) GTEST_SKIP() << reason;
  const Folder folder;
  folder.run(command + "one --gif one.gif");
  const Outcome outcome = folder.run(command + "two --gif two.gif", mpirun);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "two: 7 of 7 frames, 7 drawn, 0 kept\ntwo.gif: 7 frames\n");
  expect_same_frames(folder, 7, "one", "two");
  EXPECT_EQ(folder.read("one/frames.json"), folder.read("two/frames.json"));
  EXPECT_EQ(folder.read("one.gif"), folder.read("two.gif"));
}

TEST(FramesRanks, UnderMpiARefusalIsOneLineOfOneRank) {
  if (const std::string reason = missing(); !reason.empty()) GTEST_SKIP() << reason;
  const Folder folder;
  const Outcome outcome = folder.run("frames teapot -o d --count 0", mpirun);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(count_of(outcome.err, "error: "), 1u) << outcome.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{});
}

TEST(FramesRanks, NothingIsLostWhenARankIsKilled) {
  if (const std::string reason = missing(); !reason.empty()) GTEST_SKIP() << reason;
  const Folder folder;
  // Rank 1 dies as soon as it has drawn its second frame, long before the last of its ten.
  folder.write("rank.sh",
               "if [ $OMPI_COMM_WORLD_RANK = 1 ]; then\n"
               "  (while [ ! -e two/frame_0003.png ]; do sleep .01; done; kill -9 $$) &\n"
               "fi\n"
               "exec \"$@\"\n");
  const std::string longer = "frames teapot:8 --size 600x450 --samples 16 --count 20 -o ";
  const Outcome killed = folder.run(longer + "two", mpirun + "sh rank.sh");
  EXPECT_NE(killed.exit_code, 0);
  const Outcome repeated = folder.run(longer + "two", mpirun);
  EXPECT_EQ(repeated.exit_code, 0) << repeated.err;
  EXPECT_TRUE(repeated.out.starts_with("two: 20 of 20 frames, ")) << repeated.out;
  EXPECT_FALSE(contains(repeated.out, " 0 kept")) << repeated.out;
  folder.run(longer + "one");
  expect_same_frames(folder, 20, "one", "two");
}

}  // namespace
}  // namespace scanlit::test
