#include "lessons/assignments/sandbox/cgroup.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace scanlit::sandbox {
namespace fs = std::filesystem;
namespace {

std::string read_all(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// In one write(), as these files want it.
bool put(const fs::path& file, const std::string& text) {
  const Descriptor descriptor(open(file.c_str(), O_WRONLY | O_CLOEXEC));
  return descriptor && write(descriptor.number(), text.data(), text.size()) == ssize_t(text.size());
}

bool has_word(const std::string& list, const std::string& word) {
  std::istringstream words(list);
  for (std::string each; words >> each;)
    if (each == word) return true;
  return false;
}

/// One mounted hierarchy, with the judge's group in it.
struct Hierarchy {
  bool version2 = false;
  std::string controllers;  // version 1: "rw,pids"
  fs::path folder;          // of the judge's group
  bool is_root = false;
};

/// A line of /proc/self/mountinfo: "35 24 0:30 ROOT MOUNT rw - TYPE SOURCE OPTIONS" (proc(5)).
std::optional<Hierarchy> read_mount(const std::string& line, const std::string& groups,
                                    const fs::path& root) {
  std::istringstream words(line.substr(0, line.find(" - ")));
  std::string skipped, mount_root, mount, type, source, options;
  words >> skipped >> skipped >> skipped >> mount_root >> mount;
  if (line.find(" - ") == line.npos) return std::nullopt;
  std::istringstream(line.substr(line.find(" - ") + 3)) >> type >> source >> options;
  if (type != "cgroup" && type != "cgroup2") return std::nullopt;
  Hierarchy hierarchy{.version2 = type == "cgroup2", .controllers = options, .folder = {}};
  // A line of /proc/self/cgroup: "8:pids:/group", of version 2 "0::/group" (cgroups(7)).
  std::istringstream lines(groups);
  for (std::string group; std::getline(lines, group);) {
    const std::size_t first = group.find(':'), second = group.find(':', first + 1);
    if (first == group.npos || second == group.npos) continue;
    const std::string name = group.substr(first + 1, second - first - 1);
    std::string path = group.substr(second + 1);
    const bool same =
        hierarchy.version2
            ? name.empty()
            : !name.empty() && ("," + options + ",").find("," + name + ",") != options.npos;
    if (!same) continue;
    hierarchy.is_root = path == "/" && mount_root == "/";
    if (mount_root != "/" && path.starts_with(mount_root)) path.erase(0, mount_root.size());
    hierarchy.folder = root / fs::path(mount).relative_path() / fs::path(path).relative_path();
    return hierarchy;
  }
  return std::nullopt;
}

bool delegated(const fs::path& folder) {
  char value = 0;
  for (const char* attribute : {"user.delegate", "trusted.delegate"})
    if (getxattr(folder.c_str(), attribute, &value, 1) == 1 && value == '1') return true;
  struct stat status;
  return geteuid() != 0 && stat(folder.c_str(), &status) == 0 && status.st_uid == geteuid();
}

/// Controllers are given on to the groups below; below a group with processes of its own only at
/// the root, so that the judge moves into a group beside those of the submissions first.
void give_on(const fs::path& folder) {
  const fs::path control = folder / "cgroup.subtree_control";
  if (put(control, "+pids +memory")) return;
  const fs::path own = folder / "scanlit-judge";
  std::error_code none;
  fs::create_directory(own, none);
  if (put(own / "cgroup.procs", "0")) put(control, "+pids +memory");
}

constexpr const char* prefix = "scanlit-";

/// "scanlit-1234-7" is of judge 1234.
bool is_abandoned(const std::string& name) {
  if (!name.starts_with(prefix)) return false;
  const pid_t judge = pid_t(std::atol(name.c_str() + std::strlen(prefix)));
  return judge > 0 && kill(judge, 0) != 0 && errno == ESRCH;
}

}  // namespace

void remove_abandoned_groups(const CgroupPlace& place) {
  for (const auto& parent : {place.processes, place.memory}) {
    std::error_code none;
    if (!parent) continue;
    for (const auto& entry : fs::directory_iterator(*parent, none)) {
      if (!is_abandoned(entry.path().filename().string())) continue;
      std::ifstream processes(entry.path() / "cgroup.procs");
      for (pid_t process; processes >> process;) kill(process, SIGKILL);
      rmdir(entry.path().c_str());  // busy for a moment: the next judge removes it
    }
  }
}

CgroupPlace find_cgroup_place(const fs::path& root) {
  CgroupPlace place;
  const std::string groups = read_all(root / "proc/self/cgroup");
  std::ifstream mounts(root / "proc/self/mountinfo");
  for (std::string line; std::getline(mounts, line);) {
    const auto hierarchy = read_mount(line, groups, root);
    if (!hierarchy || !(hierarchy->is_root || delegated(hierarchy->folder))) continue;
    const fs::path& folder = hierarchy->folder;
    if (hierarchy->version2) {
      const std::string there = read_all(folder / "cgroup.controllers");
      if (!has_word(there, "pids") && !has_word(there, "memory")) continue;
      give_on(folder);
      const std::string given = read_all(folder / "cgroup.subtree_control");
      place.version2 = true;
      if (has_word(given, "pids")) place.processes = folder;
      if (has_word(given, "memory")) place.memory = folder;
    } else {
      const std::string options = "," + hierarchy->controllers + ",";
      if (options.find(",pids,") != options.npos) place.processes = folder;
      if (options.find(",memory,") != options.npos) place.memory = folder;
    }
  }
  return place;
}

Cgroup::Cgroup(const CgroupPlace& place, bool limit_processes, bool limit_memory,
               const Limits& limits) {
  static std::atomic<int> count{0};
  name_ = prefix + std::to_string(getpid()) + "-" + std::to_string(++count);
  if (limit_processes && place.processes) make(*place.processes);
  if (limit_memory && place.memory && !(limit_processes && place.memory == place.processes))
    make(*place.memory);
  if (limit_processes) set("pids.max", std::uint64_t(limits.processes));
  if (limit_memory) {
    set(place.version2 ? "memory.max" : "memory.limit_in_bytes", limits.memory_bytes);
    set("memory.swap.max", 0);
  }
}

void Cgroup::make(const fs::path& parent) {
  const fs::path folder = parent / name_;
  std::error_code none;
  fs::create_directory(folder, none);
  Descriptor door(open((folder / "cgroup.procs").c_str(), O_WRONLY | O_CLOEXEC));
  if (!door) throw Error(folder.string(), "this control group cannot be made");
  folders_.push_back(folder);
  doors_.push_back(std::move(door));
}

void Cgroup::set(const char* file, std::uint64_t most) const {
  for (const fs::path& folder : folders_) put(folder / file, std::to_string(most));
}

Cgroup::~Cgroup() {
  doors_.clear();
  // The kernel takes a moment to bury the dead, before which the folder is busy.
  constexpr int tries = 200;
  constexpr useconds_t pause_us = 1000;
  for (const fs::path& folder : folders_)
    for (int i = 0; i < tries && rmdir(folder.c_str()) != 0 && errno == EBUSY; ++i)
      usleep(pause_us);
}

}  // namespace scanlit::sandbox
