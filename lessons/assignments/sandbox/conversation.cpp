#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>

#include "lessons/assignments/sandbox/running_process.h"
#include "lessons/assignments/sandbox/sandbox.h"

namespace scanlit::sandbox {

Conversation::Conversation(std::unique_ptr<RunningProcess> process)
    : process_(std::move(process)) {}
Conversation::Conversation(Conversation&&) noexcept = default;
Conversation::~Conversation() = default;

void Conversation::send(std::span<const std::byte> question) {
  if (!process_->write(question, process_->deadline())) give_up(!process_->late && !process_->loud);
}

void Conversation::receive(std::span<std::byte> answer) {
  if (!process_->read(answer, process_->deadline())) give_up(!process_->late && !process_->loud);
}

void Conversation::give_up(bool in_time) {
  // Who closed the pipe is about to end, and how is worth to know.
  constexpr std::chrono::seconds to_end{1};
  if (in_time) process_->wait(RunningProcess::Clock::now() + to_end);
  const Outcome outcome = finish();
  using End = Outcome::End;
  if (outcome.end == End::out_of_cpu_time || outcome.end == End::out_of_wall_time)
    throw Silent(outcome, process_->launch.limits);
  throw Gone(outcome, process_->launch.limits);
}

Outcome Conversation::finish() {
  process_->end();
  return process_->outcome;
}

Outcome Conversation::hang_up() {
  process_->questions.close();
  process_->wait(process_->deadline());
  return finish();
}

std::string describe(const Outcome& outcome, const Limits& limits) {
  const auto whole = [](double seconds) { return std::to_string(long(std::ceil(seconds))) + " s"; };
  switch (outcome.end) {
    case Outcome::End::out_of_cpu_time:
      return "needed more than " + whole(limits.cpu_seconds) + " of processor time";
    case Outcome::End::out_of_wall_time: return "did nothing for " + whole(limits.wall_seconds);
    case Outcome::End::killed: {
      const char* name = sigabbrev_np(outcome.code);
      return "crashed (" + (name ? "SIG" + std::string(name) : std::to_string(outcome.code)) + ")";
    }
    case Outcome::End::too_much_output: return "printed without end";
    case Outcome::End::exited: break;
  }
  return "ended by itself, with exit status " + std::to_string(outcome.code);
}

}  // namespace scanlit::sandbox
