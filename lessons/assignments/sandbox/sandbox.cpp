#include "lessons/assignments/sandbox/sandbox.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "lessons/assignments/sandbox/running_process.h"

namespace scanlit::sandbox {
namespace fs = std::filesystem;

struct Sandbox::State {
  fs::path folder, scratch;
  std::vector<fs::path> readable;
  Limits limits;
  Layers layers;
  bool sealed = false;

  Launch prepare(const std::vector<std::string>& argv) const;
  void seal();
};

namespace {

/// What programs see of the judge's environment: nothing. The compiler's __DATE__ and __TIME__ are
/// the same in every run.
std::vector<std::string> environment(const fs::path& scratch) {
  return {"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C.UTF-8", "SOURCE_DATE_EPOCH=0",
          "HOME=" + scratch.string(), "TMPDIR=" + scratch.string()};
}

/// A name that nobody can guess, passable for programs, not listable.
fs::path make_folder(const fs::path& parent) {
  std::string name = (parent / "scanlit-XXXXXX").string();
  if (!mkdtemp(name.data())) throw Error(parent.string(), std::strerror(errno));
  chmod(name.c_str(), 0711);
  return name;
}

}  // namespace

Launch Sandbox::State::prepare(const std::vector<std::string>& argv) const {
  Launch launch;
  launch.argv = argv;
  launch.environment = environment(scratch);
  launch.folder = scratch.string();
  launch.limits = limits;
  return launch;
}

void Sandbox::State::seal() { sealed = true; }

Sandbox::Sandbox(const fs::path& parent, std::vector<fs::path> readable, const Limits& limits,
                 const Layers& layers)
    : state_(std::make_unique<State>()) {
  state_->folder = make_folder(fs::absolute(parent));
  state_->scratch = state_->folder / "work";
  fs::create_directory(state_->scratch);
  fs::permissions(state_->scratch, fs::perms::owner_all);
  state_->readable = std::move(readable);
  state_->limits = limits;
  state_->layers = layers;
}

Sandbox::~Sandbox() {
  std::error_code none;
  fs::remove_all(state_->folder, none);
}

const fs::path& Sandbox::scratch() const { return state_->scratch; }
Limits& Sandbox::limits() { return state_->limits; }
const Layers& Sandbox::layers() const { return state_->layers; }

Outcome Sandbox::run(const std::vector<std::string>& argv) {
  RunningProcess process(state_->prepare(argv), false);
  process.wait(process.deadline());
  process.end();
  return process.outcome;
}

Conversation Sandbox::start(const std::vector<std::string>& argv) {
  state_->seal();
  return Conversation(std::make_unique<RunningProcess>(state_->prepare(argv), true));
}

}  // namespace scanlit::sandbox
