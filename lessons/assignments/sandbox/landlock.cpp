#include "lessons/assignments/sandbox/landlock.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace scanlit::sandbox {
namespace {

/// As in newer kernels' linux/landlock.h; a kernel of an older version takes the first members.
struct Ruleset {
  std::uint64_t files, network, scoped;
};

constexpr std::uint64_t read_file = LANDLOCK_ACCESS_FS_READ_FILE,
                        write_file = LANDLOCK_ACCESS_FS_WRITE_FILE,
                        execute = LANDLOCK_ACCESS_FS_EXECUTE,
                        read_folder = LANDLOCK_ACCESS_FS_READ_DIR;
/// All accesses that a version of the interface knows: bits 0 to 12, then REFER (2), TRUNCATE (3)
/// and IOCTL_DEV (5).
constexpr std::uint64_t all_accesses(long version) {
  constexpr std::uint64_t refer = 1 << 13, truncate = 1 << 14, ioctl_device = 1 << 15;
  return ((1 << 13) - 1) | (version >= 2 ? refer : 0) | (version >= 3 ? truncate : 0) |
         (version >= 5 ? ioctl_device : 0);
}

void allow(int rules, const std::filesystem::path& path, std::uint64_t accesses) {
  const Descriptor file(open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status;
  if (!file || fstat(file.number(), &status) != 0) return;
  constexpr std::uint64_t truncate = 1 << 14, ioctl_device = 1 << 15;
  if (!S_ISDIR(status.st_mode))  // a file has no other rights
    accesses &= read_file | write_file | execute | truncate | ioctl_device;
  const landlock_path_beneath_attr rule{accesses, file.number()};
  syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

}  // namespace

const std::vector<std::filesystem::path>& toolchain() {
  static const std::vector<std::filesystem::path> paths{"/usr/bin",
                                                        "/usr/lib",
                                                        "/usr/lib32",
                                                        "/usr/lib64",
                                                        "/usr/libx32",
                                                        "/usr/libexec",
                                                        "/usr/include",
                                                        "/usr/local/lib",
                                                        "/usr/local/bin",
                                                        "/usr/local/include",
                                                        "/bin",
                                                        "/lib",
                                                        "/lib32",
                                                        "/lib64",
                                                        "/libx32",
                                                        "/etc/alternatives",
                                                        "/etc/ld.so.cache"};
  return paths;
}

Descriptor landlock_rules(const std::vector<std::filesystem::path>& readable,
                          const std::filesystem::path& writable) {
  const long version =
      syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return Descriptor();
  constexpr std::uint64_t bind_and_connect = 3, abstract_sockets_and_signals = 3;
  Ruleset all{all_accesses(version), version >= 4 ? bind_and_connect : 0,
              version >= 6 ? abstract_sockets_and_signals : 0};
  const std::size_t size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
  Descriptor rules(int(syscall(SYS_landlock_create_ruleset, &all, size, 0)));
  if (!rules) return rules;
  for (const auto& path : toolchain())
    allow(rules.number(), path, read_file | execute | read_folder);
  for (const auto& path : readable) allow(rules.number(), path, read_file | execute | read_folder);
  allow(rules.number(), "/dev/null", read_file | write_file);
  allow(rules.number(), "/dev/urandom", read_file);
  if (!writable.empty()) allow(rules.number(), writable, all.files);
  return rules;
}

long landlock_restrict(int rules) { return syscall(SYS_landlock_restrict_self, rules, 0); }

}  // namespace scanlit::sandbox
