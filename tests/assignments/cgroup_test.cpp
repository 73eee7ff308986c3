// Where control groups may be made, told by made-up machines, of which there are more kinds than
// there are at hand.
#include "lessons/assignments/sandbox/cgroup.h"

#include <gtest/gtest.h>

#include <fstream>

#include "lessons/studio/tradeoff/temporary_folder.h"

namespace scanlit::sandbox {
namespace {

namespace fs = std::filesystem;

class Machine {
 public:
  Machine(const std::string& groups, const std::string& mounts) {
    write("proc/self/cgroup", groups);
    write("proc/self/mountinfo", mounts);
  }
  void write(const std::string& file, const std::string& text) {
    const fs::path path = root() / file;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  std::string read(const std::string& file) const {
    std::ifstream stream(root() / file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  fs::path root() const { return folder_.file("root"); }
  CgroupPlace place() const { return find_cgroup_place(root()); }

 private:
  studio::TemporaryFolder folder_;
};

const std::string version1 =
    "39 31 0:36 / /sys/fs/cgroup/pids rw,relatime - cgroup cgroup rw,pids\n"
    "35 31 0:32 / /sys/fs/cgroup/memory rw,relatime - cgroup cgroup rw,memory\n";
const std::string version2 = "30 23 0:26 / /sys/fs/cgroup rw,nosuid - cgroup2 cgroup2 rw\n";

TEST(CgroupPlace, OfVersion1IsTheRootOfEachHierarchy) {
  const Machine machine("8:pids:/\n4:memory:/\n0::/\n", version1);
  EXPECT_EQ(machine.place().processes, machine.root() / "sys/fs/cgroup/pids/");
  EXPECT_EQ(machine.place().memory, machine.root() / "sys/fs/cgroup/memory/");
  EXPECT_FALSE(machine.place().version2);
}

TEST(CgroupPlace, LeavesAnotherManagersGroupsAlone) {
  const Machine machine("8:pids:/\n4:memory:/service/1\n", version1);
  EXPECT_TRUE(machine.place().processes);
  EXPECT_FALSE(machine.place().memory);
}

TEST(CgroupPlace, OfVersion2GivesControllersOn) {
  Machine machine("0::/\n", version2);
  machine.write("sys/fs/cgroup/cgroup.controllers", "cpu memory pids\n");
  machine.write("sys/fs/cgroup/cgroup.subtree_control", "");
  // A real one would now say what was given on: "memory pids".
  const CgroupPlace place = machine.place();
  EXPECT_TRUE(place.version2);
  EXPECT_EQ(machine.read("sys/fs/cgroup/cgroup.subtree_control"), "+pids +memory");
  machine.write("sys/fs/cgroup/cgroup.controllers", "hugetlb\n");
  EXPECT_FALSE(machine.place().version2);
}

TEST(Cgroup, IsMadeWhereGroupsAre) {
  Machine machine("", "");
  const fs::path parent = machine.root() / "parent";
  fs::create_directories(parent);
  const CgroupPlace place{.processes = parent, .memory = parent, .version2 = true};
  // No door: a folder that is no control group's has no cgroup.procs.
  EXPECT_THROW(Cgroup(place, true, true, Limits{}), Error);
}

TEST(CgroupPlace, IsNowhereWithoutControlGroups) {
  const Machine machine("", "22 27 0:21 / /proc rw,relatime - proc proc rw\n");
  EXPECT_FALSE(machine.place().processes);
  EXPECT_FALSE(machine.place().memory);
}

}  // namespace
}  // namespace scanlit::sandbox
