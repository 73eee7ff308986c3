#include "lessons/assignments/sandbox/running_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace scanlit::sandbox {
namespace {

using std::chrono::milliseconds;

void do_not_block(const Descriptor& pipe) { fcntl(pipe.number(), F_SETFL, O_NONBLOCK); }

/// write() to a pipe that nobody reads any more fails and does not end the judge.
ssize_t write_quietly(int descriptor, std::span<const std::byte> bytes) {
  sigset_t pipe_signal, before;
  sigemptyset(&pipe_signal);
  sigaddset(&pipe_signal, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
  const ssize_t size = ::write(descriptor, bytes.data(), bytes.size());
  const int number = errno;
  constexpr timespec at_once{};
  if (size < 0 && number == EPIPE) sigtimedwait(&pipe_signal, nullptr, &at_once);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = number;
  return size;
}

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

}  // namespace

RunningProcess::RunningProcess(Launch what, bool conversation, std::function<void()> kill_user)
    : launch(std::move(what)), kill_user_(std::move(kill_user)) {
  Pipe printed = make_pipe(), asked, answered;
  launch.output = printed.write.number();
  if (conversation) {
    asked = make_pipe();
    answered = make_pipe();
    launch.questions = asked.read.number();
    launch.answers = answered.write.number();
  }
  pid = sandbox::launch(launch);
  output = std::move(printed.read);
  questions = std::move(asked.write);
  answers = std::move(answered.read);
  for (const Descriptor* pipe : {&output, &questions, &answers}) do_not_block(*pipe);
}

RunningProcess::Clock::time_point RunningProcess::deadline() const {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(launch.limits.wall_seconds));
}

void RunningProcess::keep_output() {
  std::array<char, 65536> buffer;
  const ssize_t size = ::read(output.number(), buffer.data(), buffer.size());
  if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) output.close();
  const std::size_t room = launch.limits.output_bytes - outcome.output.size();
  if (size <= 0) return;
  outcome.output.append(buffer.data(), std::min(room, std::size_t(size)));
  constexpr std::uint64_t patience = 16;  // an honest student's traces are dropped, not punished
  printed_ += std::uint64_t(size);
  loud = printed_ > patience * launch.limits.output_bytes;
}

bool RunningProcess::has_ended() {
  if (ended_) return true;
  siginfo_t info{};
  ended_ = waitid(P_PID, id_t(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid;
  return ended_;
}

/// Of all processes in the session that `leader` began, in clock ticks: proc(5), /proc/PID/stat,
/// fields 6, 14 and 15.
long computed_in_session(pid_t leader) {
  long ticks = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    if (!std::isdigit(static_cast<unsigned char>(entry.path().filename().c_str()[0]))) continue;
    std::string line;
    std::getline(std::ifstream(entry.path() / "stat"), line);
    const std::size_t name_end = line.rfind(')');
    long session = 0, user = 0, system = 0;
    if (name_end != line.npos &&
        std::sscanf(line.c_str() + name_end + 1,
                    " %*c %*d %*d %ld %*d %*d %*u %*u %*u %*u %*u %ld %ld", &session, &user,
                    &system) == 3 &&
        session == leader)
      ticks += user + system;
  }
  return ticks;
}

bool RunningProcess::idle() {
  // On a machine that others use, too, a program may wait for a processor rather than for nothing;
  // its limit is processor time.
  const long before = std::exchange(computed_, computed_in_session(pid));
  return computed_ <= before;
}

bool RunningProcess::too_old() const {
  // Who looks busy, or sleeps before each answer but not too long, is ended at last.
  constexpr int patience = 10;
  const std::chrono::duration<double> lived = Clock::now() - start_;
  return lived.count() > patience * launch.limits.wall_seconds;
}

bool RunningProcess::ready(int descriptor, short event, Clock::time_point& deadline) {
  // Closed pipes wake the judge; what ends and leaves its pipes to a child is noticed by and by.
  constexpr milliseconds look_again{20};
  std::array<pollfd, 2> pipes{pollfd{descriptor, event, 0}, pollfd{output.number(), POLLIN, 0}};
  auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
  if (left.count() <= 0 || too_old()) {
    if (too_old() || idle()) {
      late = true;
      return false;
    }
    deadline = this->deadline();
    left = look_again;
  }
  poll(pipes.data(), pipes.size(), int(std::min(left, look_again).count()));
  if (pipes[1].revents != 0) keep_output();
  return pipes[0].revents != 0;
}

bool RunningProcess::wait(Clock::time_point deadline) {
  while (!has_ended() && !given_up()) ready(-1, 0, deadline);
  return !given_up();
}

bool RunningProcess::write(std::span<const std::byte> bytes, Clock::time_point deadline) {
  while (!bytes.empty()) {
    const ssize_t size = write_quietly(questions.number(), bytes);
    if (size > 0) bytes = bytes.subspan(std::size_t(size));
    if (size < 0 && errno != EAGAIN && errno != EINTR) return false;
    if (size < 0 && !ready(questions.number(), POLLOUT, deadline) && (given_up() || has_ended()))
      return false;
  }
  return true;
}

bool RunningProcess::read(std::span<std::byte> bytes, Clock::time_point deadline) {
  while (!bytes.empty()) {
    const bool was_over = has_ended();  // asked first: what it wrote before is still in the pipe
    const ssize_t size = ::read(answers.number(), bytes.data(), bytes.size());
    if (size > 0) bytes = bytes.subspan(std::size_t(size));
    if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) return false;
    if (size < 0 && was_over) return false;
    if (size < 0 && !ready(answers.number(), POLLIN, deadline) && given_up()) return false;
  }
  return true;
}

void RunningProcess::end() {
  if (over_ || pid < 0) return;
  over_ = true;
  kill(-pid, SIGKILL);
  int status = 0;
  rusage used{};
  while (wait4(pid, &status, 0, &used) < 0 && errno == EINTR) {
  }
  if (kill_user_) kill_user_();
  while (output) {  // what was printed before, at most what a pipe holds
    std::array<pollfd, 1> pipe{pollfd{output.number(), POLLIN, 0}};
    if (poll(pipe.data(), 1, 0) <= 0) break;
    keep_output();
  }
  using End = Outcome::End;
  outcome.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  outcome.end = WIFSIGNALED(status) ? End::killed : End::exited;
  outcome.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  constexpr int killed_inside = 128;  // as bwrap says that a signal has killed the program
  if (launch.bubblewrap && outcome.end == End::exited && outcome.code > killed_inside) {
    outcome.end = End::killed;
    outcome.code -= killed_inside;
  }
  // A compiler's driver, which loses a child so, says it in its output.
  if (outcome.end == End::killed && outcome.code == SIGXCPU) outcome.end = End::out_of_cpu_time;
  if (late) outcome.end = End::out_of_wall_time;
  if (loud) outcome.end = End::too_much_output;
}

}  // namespace scanlit::sandbox
