// What `scanlit` and the lessons share as command-line programs: errors become one line and an exit
// code, an unknown option gets a suggestion, and a signal leaves no half-written file.
#pragma once

#include <array>
#include <csignal>
#include <functional>
#include <string>

namespace CLI {
class App;  // not its header, which takes seconds to compile
}

namespace scanlit::studio {

/// 2: bad input, or not enough memory; 1: a fault of the program itself.
constexpr int exit_bad_input = 2, exit_internal = 1;

/// Adds options and commands to the program, and returns what to do when they have been read.
using Setup = std::function<std::function<void()>(CLI::App&)>;

/// A program's main(): what is thrown becomes one line "error: ..." on stderr and the exit code
/// that is returned. `--help` and `--version` print and return 0 without doing what the setup
/// returned.
int run_program(const std::string& name, int argc, char** argv, const Setup& setup);

/// While it lives, Ctrl-C and its like wait: a picture is written beside its place first, and a
/// program killed in that moment would leave the temporary file.
class HoldInterrupts {
 public:
  HoldInterrupts();
  ~HoldInterrupts();
  HoldInterrupts(const HoldInterrupts&) = delete;
  HoldInterrupts& operator=(const HoldInterrupts&) = delete;

 private:
  static constexpr std::array held_signals{SIGINT, SIGTERM, SIGHUP};
  std::array<void (*)(int), held_signals.size()> before_;
};

/// "warning: ..." and "note: ...", one line each, on stderr.
void warn(const std::string& message);
void note(const std::string& message);

}  // namespace scanlit::studio
