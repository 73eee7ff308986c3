// The layer `cgroup`: limits of all processes of a submission together, by Linux's control groups.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lessons/assignments/sandbox/launch.h"

namespace scanlit::sandbox {

/// Where control groups of ours may be made, one folder per controller: in version 2 the same
/// folder for both, in version 1 one of each hierarchy. Only where the judge's own group is the
/// root, or was delegated to it (the attribute user.delegate or trusted.delegate that systemd sets,
/// or a folder that belongs to the judge's user): another manager's groups are left alone.
struct CgroupPlace {
  std::optional<std::filesystem::path> processes, memory;
  bool version2 = false;
};

/// Reads /proc/self/cgroup and /proc/self/mountinfo below `root`, which is another one in tests.
CgroupPlace find_cgroup_place(const std::filesystem::path& root = "/");

/// Ends and removes groups of judges that were killed.
void remove_abandoned_groups(const CgroupPlace& place);

/// A group that a program is started in, with its limits.
class Cgroup {
 public:
  /// Throws Error where it cannot be made.
  Cgroup(const CgroupPlace& place, bool limit_processes, bool limit_memory, const Limits& limits);
  ~Cgroup();  // of a group whose processes are dead
  Cgroup(const Cgroup&) = delete;

  /// A process that writes "0" to each of these is in the group.
  const std::vector<Descriptor>& doors() const { return doors_; }

 private:
  void make(const std::filesystem::path& parent);
  void set(const char* file, std::uint64_t most) const;

  std::string name_;
  std::vector<std::filesystem::path> folders_;
  std::vector<Descriptor> doors_;
};

}  // namespace scanlit::sandbox
