#include "tests/assignments/hostile_program.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>

namespace scanlit::test {

std::string name_of_layers(const testing::TestParamInfo<sandbox::Layers>& layers) {
  std::string name;
  for (const char c : sandbox::in_force(layers.param))
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

bool thorough() { return std::getenv("SCANLIT_LONG"); }

std::vector<sandbox::Layers> shown_layers() {
  const sandbox::Layers all = sandbox::available();
  std::vector<sandbox::Layers> shown;
  const auto show = [&](const sandbox::Layers& wanted) {
    const sandbox::Layers layers{
        .uid = wanted.uid && all.uid,
        .seccomp = wanted.seccomp && all.seccomp,
        .landlock = wanted.landlock && !wanted.bubblewrap,
        .bubblewrap = wanted.bubblewrap && all.bubblewrap,
        .cgroup_processes = wanted.cgroup_processes && all.cgroup_processes,
        .cgroup_memory = wanted.cgroup_memory && all.cgroup_memory};
    for (const sandbox::Layers& other : shown)
      if (other == layers) return;
    shown.push_back(layers);
  };
  const bool landlock = sandbox::has_landlock();
  show({.uid = true});
  if (thorough()) show({.uid = true, .seccomp = true});
  if (thorough()) show({.uid = true, .bubblewrap = true});
  if (thorough()) show({.uid = true, .cgroup_processes = true, .cgroup_memory = true});
  if (thorough() && landlock) show({.uid = true, .landlock = true});
  if (landlock) show({.uid = true, .seccomp = true, .landlock = true});
  show(all);
  return shown;
}

sandbox::Outcome compile(sandbox::Sandbox& box, const std::string& source) {
  std::ofstream(box.scratch() / "source.cpp") << source;
  return box.run({SCANLIT_CXX, "-std=c++20", "-O1", "source.cpp", "-o", "program"});
}

namespace {

const std::string& compiled(const std::string& source) {
  static std::map<std::string, std::string> programs;
  const auto [place, is_new] = programs.try_emplace(source);
  if (!is_new) return place->second;
  sandbox::Sandbox box(std::filesystem::temp_directory_path(), {}, for_compiler(),
                       sandbox::available());
  const sandbox::Outcome outcome = compile(box, source);
  if (!outcome.good()) throw Error("test program", outcome.output);
  std::ifstream file(box.scratch() / "program", std::ios::binary);
  return place->second = {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

HostileProgram::HostileProgram(const std::string& source, const sandbox::Layers& layers)
    : box_(std::filesystem::temp_directory_path(), {}, mild(), layers) {
  std::ofstream(program(), std::ios::binary) << compiled(source);
}

/// Of one of the users that submissions get, dead ones too.
int processes_of(uid_t user) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    struct stat status;
    count += stat(entry.path().c_str(), &status) == 0 && status.st_uid == user;
  }
  return count;
}

void HostileProgram::expect_nothing_left() const {
  if (box_.user() != 0) {
    EXPECT_EQ(processes_of(box_.user()), 0);
  }
}

sandbox::Outcome HostileProgram::run(const sandbox::Limits& limits) {
  box_.limits() = limits;
  const sandbox::Outcome outcome = box_.run({program().string()});
  expect_nothing_left();
  return outcome;
}

sandbox::Conversation HostileProgram::start(const sandbox::Limits& limits) {
  box_.limits() = limits;
  return box_.start({program().string()});
}

sandbox::Outcome HostileProgram::answer(const sandbox::Limits& limits) {
  sandbox::Conversation conversation = start(limits);
  try {
    int number = 1;
    conversation.send(std::as_bytes(std::span(&number, 1)));
    conversation.receive(std::as_writable_bytes(std::span(&number, 1)));
  } catch (const sandbox::NoAnswer&) {
  }
  const sandbox::Outcome outcome = conversation.finish();
  expect_nothing_left();
  return outcome;
}

}  // namespace scanlit::test
