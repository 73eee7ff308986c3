// Runs programs that nobody trusts: a student's, and the compiler over a student's files. The
// layers between such a program and the rest of the machine are in a file of their own each, and
// layers.h says what each of them gives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lessons/assignments/sandbox/layers.h"
#include "rasterizer/error.h"

namespace scanlit::sandbox {

/// What a program may use. At the limit it is refused more, or killed.
struct Limits {
  double cpu_seconds = 10;   // of processor time, each process
  double wall_seconds = 60;  // of a run or an answer in which nothing is computed; 10 times, of all
  std::uint64_t memory_bytes = 512 << 20;  // each process; with cgroups all of them together
  std::uint64_t output_bytes = 1 << 20;    // kept of what it prints; 16 times as much ends it
  std::uint64_t file_bytes = 64 << 20;     // each file that it writes
  int processes = 32;                      // at a time; held only where layers.uid or cgroup is
};

/// How a program ended.
struct Outcome {
  enum class End { exited, killed, out_of_cpu_time, out_of_wall_time, too_much_output };
  End end = End::exited;
  int code = 0;          // exit status, or the number of the signal that killed it
  std::string output;    // what it printed: anything at all, up to Limits::output_bytes
  double cpu_seconds{};  // of all its processes; behind bubblewrap only of bwrap

  bool good() const { return end == End::exited && code == 0; }
};

/// "ended by itself, with exit status 3", "crashed (SIGSEGV)", "needed more than 10 s of processor
/// time": after "the program".
std::string describe(const Outcome& outcome, const Limits& limits);

/// Removes what the sandboxes of judges that were killed have left in `parent`.
void remove_abandoned(const std::filesystem::path& parent);

/// Thrown in place of an answer. The conversation is over and all its processes are dead.
struct NoAnswer : Error {
  NoAnswer(Outcome how_it_ended, const Limits& limits)
      : Error(describe(how_it_ended, limits)), outcome(std::move(how_it_ended)) {}
  Outcome outcome;
};
struct Silent : NoAnswer {  // it ran out of time
  using NoAnswer::NoAnswer;
};
struct Gone : NoAnswer {  // it crashed or ended by itself
  using NoAnswer::NoAnswer;
};

struct RunningProcess;

/// A program that answers questions: it reads them from its standard input and writes answers to
/// its standard output; what it writes to standard error is kept as text. One at a time per
/// Sandbox.
class Conversation {
 public:
  explicit Conversation(std::unique_ptr<RunningProcess> process);
  Conversation(Conversation&&) noexcept;
  ~Conversation();  // kills the program and all that it started

  /// Both throw Silent where the program neither reads nor writes in time, and Gone where it ends.
  void send(std::span<const std::byte> question);
  void receive(std::span<std::byte> answer);

  /// Ends it now and says how it was until then. What it printed is in the outcome.
  Outcome finish();
  /// Asks nothing more and lets it end by itself, in time.
  Outcome hang_up();

 private:
  [[noreturn]] void give_up(bool in_time);
  std::unique_ptr<RunningProcess> process_;
};

class Sandbox {
 public:
  /// Makes an empty folder of its own in `parent` that others can pass through but not list.
  /// Programs see it, `readable` (files or folders, absolute), and the system's toolchain. Throws
  /// Error where `parent` is not writable or a layer asked for cannot be had.
  Sandbox(const std::filesystem::path& parent, std::vector<std::filesystem::path> readable,
          const Limits& limits, const Layers& layers);
  ~Sandbox();  // kills what is left and removes the folder
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// Put here what is to be compiled: regular files. Programs start in it.
  const std::filesystem::path& scratch() const;

  /// What valgrind wants of a program's surroundings: those that are started next may read /proc,
  /// behind bubblewrap that of their own processes, else of all, as far as their user may look; and
  /// have a folder for temporary files.
  void allow_valgrind();

  Limits& limits();  // of the programs that are started next
  const Layers& layers() const;
  unsigned user() const;  // of Layers::uid; 0 without

  /// Runs a program, such as a compiler, that may write in scratch(). `argv[0]` is an absolute
  /// path. Throws Error where it cannot be started.
  Outcome run(const std::vector<std::string>& argv);

  /// Starts a program to talk to. From now on scratch() is the judge's, and programs only read it.
  Conversation start(const std::vector<std::string>& argv);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scanlit::sandbox
