// Tiny programs as a student may hand them in, compiled by the sandboxed compiler.
#pragma once

#include <filesystem>
#include <string>

#include "lessons/assignments/sandbox/sandbox.h"

namespace scanlit::test {

/// Mild enough for a machine that others use, too.
inline sandbox::Limits mild() {
  return {.cpu_seconds = 1,
          .wall_seconds = 2,
          .memory_bytes = 256 << 20,
          .output_bytes = 1 << 20,
          .file_bytes = 4 << 20,
          .processes = 24};
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

/// A sandbox with one source file, in C++ without the standard library's headers, and its program.
class HostileProgram {
 public:
  explicit HostileProgram(const std::string& source,
                          const sandbox::Layers& layers = sandbox::available());

  const sandbox::Outcome& build() const { return build_; }
  sandbox::Sandbox& box() { return box_; }
  std::filesystem::path program() const { return box_.scratch() / "program"; }

  sandbox::Outcome run(const sandbox::Limits& limits = mild());
  sandbox::Conversation start(const sandbox::Limits& limits = mild());

 private:
  sandbox::Sandbox box_;
  sandbox::Outcome build_;
};

}  // namespace scanlit::test
