// From a decision what to start to a process: the fork, and what the child does before the program
// takes over.
#pragma once

#include <linux/filter.h>
#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "lessons/assignments/sandbox/sandbox.h"

namespace scanlit::sandbox {

/// Closes what it holds; -1 holds nothing.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }
  int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  void close();

 private:
  int number_;
};

struct Pipe {
  Descriptor read, write;
};
Pipe make_pipe();  // closed on exec

/// All that the child needs, made before the fork: between fork and exec a child of a program with
/// threads may not even ask for memory.
struct Launch {
  std::vector<std::string> argv, environment;
  std::string folder;
  Limits limits;
  int processes = -1;  // of the user; -1 where they are not counted apart
  uid_t user = 0;      // 0: the judge's own
  int output = -1, questions = -1, answers = -1;
  std::vector<int> cgroup_doors;
  int landlock = -1;                                 // rules
  const std::vector<sock_filter>* filter = nullptr;  // of system calls
  bool bubblewrap = false;  // argv is behind bwrap, which drops rights by itself
};

/// Where bwrap finds the filter of system calls.
constexpr int filter_descriptor = 3;

/// Throws Error with `argv[0]` where it cannot be started.
pid_t launch(const Launch& launch);

}  // namespace scanlit::sandbox
