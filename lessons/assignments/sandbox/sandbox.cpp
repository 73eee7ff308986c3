#include "lessons/assignments/sandbox/sandbox.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "lessons/assignments/sandbox/bubblewrap.h"
#include "lessons/assignments/sandbox/cgroup.h"
#include "lessons/assignments/sandbox/landlock.h"
#include "lessons/assignments/sandbox/running_process.h"
#include "lessons/assignments/sandbox/seccomp_filter.h"
#include "lessons/assignments/sandbox/user.h"

namespace scanlit::sandbox {
namespace fs = std::filesystem;

struct Sandbox::State {
  fs::path folder, scratch, temporary;  // the last for valgrind alone
  std::vector<fs::path> readable;
  Limits limits;
  Layers layers;
  std::unique_ptr<UserLease> user;
  // Of the program that was started last.
  std::unique_ptr<Cgroup> cgroup;
  Descriptor landlock;
  bool sealed = false;

  std::unique_ptr<RunningProcess> start(const std::vector<std::string>& argv, bool conversation);
  Launch prepare(const std::vector<std::string>& argv);
  void give(const fs::path& path) const;
  void seal();
};

namespace {

/// What programs see of the judge's environment: nothing. The compiler's __DATE__ and __TIME__ are
/// the same in every run.
std::vector<std::string> environment(const fs::path& scratch, const fs::path& temporary) {
  return {"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C.UTF-8", "SOURCE_DATE_EPOCH=0",
          "HOME=" + scratch.string(), "TMPDIR=" + temporary.string()};
}

constexpr const char* prefix = "scanlit-box-";

/// Says whose it is, and nobody can guess it. Passable for programs, not listable.
fs::path make_folder(const fs::path& parent) {
  std::string name = (parent / (prefix + std::to_string(getpid()) + "-XXXXXX")).string();
  if (!mkdtemp(name.data())) throw Error(parent.string(), std::strerror(errno));
  chmod(name.c_str(), 0711);
  return name;
}

}  // namespace

void remove_abandoned(const fs::path& parent) {
  remove_abandoned_groups(find_cgroup_place());
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(parent, none)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const pid_t judge = pid_t(std::atol(name.c_str() + std::strlen(prefix)));
    if (judge > 0 && kill(judge, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), none);
  }
}

/// One submission's scratch is the next one's secret: no rights for anybody else.
void Sandbox::State::give(const fs::path& path) const {
  const bool own = user && !sealed;
  const uid_t owner = own ? user->user() : geteuid();
  const gid_t group = user ? user->user() : getegid();
  if (lchown(path.c_str(), owner, group) != 0) throw Error(path.string(), std::strerror(errno));
  if (!fs::is_symlink(path)) chmod(path.c_str(), sealed && user ? 0750 : 0700);
}

/// What the compiler has written becomes the judge's; no kind of file but these two has a purpose.
void Sandbox::State::seal() {
  sealed = true;
  give(scratch);
  std::vector<fs::path> superfluous;
  for (const auto& entry : fs::recursive_directory_iterator(scratch)) {
    const fs::file_status status = entry.symlink_status();
    if (fs::is_regular_file(status) || fs::is_directory(status))
      give(entry.path());
    else
      superfluous.push_back(entry.path());
  }
  for (const fs::path& path : superfluous) fs::remove(path);
}

Launch Sandbox::State::prepare(const std::vector<std::string>& argv) {
  Launch launch;
  launch.argv = argv;
  launch.environment = environment(scratch, layers.bubblewrap   ? "/tmp"
                                            : temporary.empty() ? scratch
                                                                : temporary);
  launch.folder = scratch.string();
  launch.limits = limits;
  if (user) {
    launch.user = user->user();
    launch.processes = limits.processes + (layers.bubblewrap ? bubblewrap_processes : 0);
  }
  if (layers.seccomp) launch.filter = &seccomp_filter(limits.processes > 1);
  if (layers.cgroup_processes || layers.cgroup_memory) {
    Limits together = limits;
    if (layers.bubblewrap) together.processes += bubblewrap_processes;
    cgroup = std::make_unique<Cgroup>(find_cgroup_place(), layers.cgroup_processes,
                                      layers.cgroup_memory, together);
    for (const Descriptor& door : cgroup->doors()) launch.cgroup_doors.push_back(door.number());
  }
  if (layers.bubblewrap) {
    launch.bubblewrap = true;
    launch.argv = bubblewrapped(argv, readable, scratch, !sealed,
                                sealed && temporary.empty() ? 0 : limits.file_bytes,
                                launch.filter ? filter_descriptor : -1);
  } else if (layers.landlock) {
    std::vector<fs::path> seen = readable;
    seen.push_back(scratch);
    landlock = landlock_rules(seen, sealed ? temporary : scratch);
    launch.landlock = landlock.number();
  }
  return launch;
}

std::unique_ptr<RunningProcess> Sandbox::State::start(const std::vector<std::string>& argv,
                                                      bool conversation) {
  return std::make_unique<RunningProcess>(prepare(argv), conversation, [this] {
    if (user) user->kill_all();
  });
}

Sandbox::Sandbox(const fs::path& parent, std::vector<fs::path> readable, const Limits& limits,
                 const Layers& layers)
    : state_(std::make_unique<State>()) {
  state_->readable = std::move(readable);
  state_->limits = limits;
  state_->layers = layers;
  if (layers.uid) state_->user = std::make_unique<UserLease>();
  state_->folder = make_folder(fs::absolute(parent));
  state_->scratch = state_->folder / "work";
  fs::create_directory(state_->scratch);
  state_->give(state_->scratch);
}

Sandbox::~Sandbox() {
  if (state_->user) state_->user->kill_all();
  std::error_code none;
  fs::remove_all(state_->folder, none);
}

const fs::path& Sandbox::scratch() const { return state_->scratch; }
void Sandbox::allow_valgrind() {
  state_->readable.push_back("/proc");
  state_->temporary = state_->folder / "tmp";
  fs::create_directories(state_->temporary);
  const uid_t owner = state_->user ? state_->user->user() : geteuid();
  if (chown(state_->temporary.c_str(), owner, gid_t(-1)) != 0)
    throw Error(state_->temporary.string(), std::strerror(errno));
}
Limits& Sandbox::limits() { return state_->limits; }
const Layers& Sandbox::layers() const { return state_->layers; }
unsigned Sandbox::user() const { return state_->user ? state_->user->user() : 0; }

Outcome Sandbox::run(const std::vector<std::string>& argv) {
  if (!state_->sealed)
    for (const auto& entry : fs::directory_iterator(state_->scratch)) state_->give(entry.path());
  const auto process = state_->start(argv, false);
  process->wait(process->deadline());
  process->end();
  return process->outcome;
}

Conversation Sandbox::start(const std::vector<std::string>& argv) {
  if (!state_->sealed) state_->seal();
  return Conversation(state_->start(argv, true));
}

}  // namespace scanlit::sandbox
