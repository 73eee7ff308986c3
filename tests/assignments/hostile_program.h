// Tiny programs as a student may hand them in, compiled by the sandboxed compiler, and run behind
// the layers that a test asks for.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lessons/assignments/sandbox/sandbox.h"

namespace scanlit::test {

/// Mild enough for a machine that others use, too.
inline sandbox::Limits mild() {
  return {.cpu_seconds = 1,
          .wall_seconds = 60,
          .memory_bytes = 256 << 20,
          .output_bytes = 1 << 20,
          .file_bytes = 4 << 20,
          .processes = 12};
}

/// For programs that wait.
inline sandbox::Limits impatient() {
  sandbox::Limits limits = mild();
  limits.wall_seconds = 1;
  return limits;
}

/// Limits that GCC needs for a small file.
inline sandbox::Limits for_compiler() {
  return {.cpu_seconds = 20,
          .wall_seconds = 60,
          .memory_bytes = 1 << 30,
          .output_bytes = 1 << 16,
          .file_bytes = 64 << 20,
          .processes = 16};
}

/// Whether SCANLIT_LONG is in the environment, as tests/run --long has it.
bool thorough();

/// Combinations of layers that this machine can show, from the least to all: some of them, or
/// one with each.
std::vector<sandbox::Layers> shown_layers();

/// Compiles one file, in the sandbox given, to `program` there.
sandbox::Outcome compile(sandbox::Sandbox& box, const std::string& source);

/// A sandbox with the program of `source` in it. It is compiled once for all layers.
class HostileProgram {
 public:
  explicit HostileProgram(const std::string& source,
                          const sandbox::Layers& layers = sandbox::available());

  sandbox::Sandbox& box() { return box_; }
  std::filesystem::path program() const { return box_.scratch() / "program"; }

  /// As a compiler runs: it may write in its folder.
  sandbox::Outcome run(const sandbox::Limits& limits = mild());
  /// As an answer runs.
  sandbox::Conversation start(const sandbox::Limits& limits = mild());
  /// As an answer that is asked one number, until it has answered wrongly or not: how it ended.
  sandbox::Outcome answer(const sandbox::Limits& limits = mild());

 private:
  /// Of a user of its own, whatever it tried.
  void expect_nothing_left() const;

  sandbox::Sandbox box_;
};

/// Tests that are run behind each of shown_layers().
class Hostile : public testing::TestWithParam<sandbox::Layers> {
 protected:
  HostileProgram program(const std::string& source) const {
    return HostileProgram(source, GetParam());
  }
};

/// What the tiny programs include.
inline const std::string headers =
    "#include <errno.h>\n#include <initializer_list>\n#include <fcntl.h>\n#include <signal.h>\n"
    "#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n"
    "#include <sys/socket.h>\n#include <sys/stat.h>\n"
    "#include <sys/wait.h>\n#include <unistd.h>\n";

/// A test's name says the layers.
std::string name_of_layers(const testing::TestParamInfo<sandbox::Layers>& layers);

}  // namespace scanlit::test
