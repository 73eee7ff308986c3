#include "lessons/assignments/sandbox/bubblewrap.h"

#include "lessons/assignments/sandbox/landlock.h"

namespace scanlit::sandbox {
namespace fs = std::filesystem;
namespace {

using Words = std::vector<std::string>;

void add(Words& words, std::initializer_list<std::string> more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// /bin is a link to /usr/bin on most systems, and has to be one inside, too.
void mount_read_only(Words& words, const fs::path& path) {
  std::error_code none;
  const fs::path parent = path.parent_path();
  if (fs::is_symlink(path, none) && parent == parent.root_path())
    add(words, {"--symlink", fs::read_symlink(path).string(), path.string()});
  else
    add(words, {"--ro-bind-try", path.string(), path.string()});
}

}  // namespace

Words bubblewrapped(const Words& program, const std::vector<fs::path>& readable,
                    const fs::path& scratch, bool writable, std::uint64_t tmp_bytes, int filter) {
  Words words{"/usr/bin/bwrap", "--unshare-all", "--die-with-parent", "--cap-drop", "ALL"};
  for (const fs::path& path : toolchain()) mount_read_only(words, path);
  add(words, {"--dev-bind", "/dev/null", "/dev/null"});
  add(words, {"--dev-bind", "/dev/urandom", "/dev/urandom"});
  if (tmp_bytes > 0) add(words, {"--size", std::to_string(tmp_bytes), "--tmpfs", "/tmp"});
  for (const fs::path& path : readable)
    path == "/proc" ? add(words, {"--proc", "/proc"})
                    : add(words, {"--ro-bind", path.string(), path.string()});
  add(words, {writable ? "--bind" : "--ro-bind", scratch.string(), scratch.string()});
  add(words, {"--remount-ro", "/", "--chdir", scratch.string()});
  if (filter >= 0) add(words, {"--seccomp", std::to_string(filter)});
  words.push_back("--");
  words.insert(words.end(), program.begin(), program.end());
  return words;
}

}  // namespace scanlit::sandbox
