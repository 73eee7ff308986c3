// A program while it runs, seen from the judge: what it says, how long it may take, how it ends.
#pragma once

#include <chrono>
#include <functional>

#include "lessons/assignments/sandbox/launch.h"

namespace scanlit::sandbox {

struct RunningProcess {
  using Clock = std::chrono::steady_clock;

  /// Starts it. `questions` and `answers` stay empty unless it is a conversation. `kill_user` ends
  /// what has left the program's session.
  RunningProcess(Launch what, bool conversation, std::function<void()> kill_user);
  ~RunningProcess() { end(); }
  RunningProcess(const RunningProcess&) = delete;

  /// Until the program has ended by itself, or the deadline is over.
  bool wait(Clock::time_point deadline);
  /// Until all of `bytes` is written or read; false where the pipe's other end was closed. Throws
  /// nothing: where the deadline is over, `late` is set and the result false.
  bool write(std::span<const std::byte> bytes, Clock::time_point deadline);
  bool read(std::span<std::byte> bytes, Clock::time_point deadline);

  /// Kills all that is left, and fills in `outcome`. Safe to repeat.
  void end();

  Clock::time_point deadline() const;

  Launch launch;
  Descriptor output, questions, answers;  // the judge's ends
  pid_t pid = -1;
  bool late = false;  // a deadline was over
  bool loud = false;  // it printed far more than is kept
  Outcome outcome;

 private:
  /// Sleeps until the pipe is ready, some milliseconds are over, or the deadline is, which a
  /// program that computes puts off. Keeps what the program prints meanwhile.
  bool ready(int descriptor, short event, Clock::time_point& deadline);
  void keep_output();
  bool idle();  // nothing was computed since the last time
  bool too_old() const;
  bool given_up() const { return late || loud; }
  bool has_ended();

  std::function<void()> kill_user_;
  bool ended_ = false;  // and not reaped
  bool over_ = false;   // reaped
  std::uint64_t printed_ = 0;
  long computed_ = 0;  // clock ticks, when idle() was asked last
  Clock::time_point start_ = Clock::now();
};

}  // namespace scanlit::sandbox
