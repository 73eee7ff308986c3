#include "lessons/assignments/sandbox/launch.h"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <system_error>

#include "lessons/assignments/sandbox/landlock.h"

namespace scanlit::sandbox {

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

Pipe make_pipe() {
  std::array<int, 2> ends;
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error("pipe", std::generic_category().message(errno));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

namespace {

/// What a child says where it cannot become the program.
struct Failure {
  const char* step;  // of a string literal, at the same address in parent and child
  int number;        // errno
};

class Child {
 public:
  Child(const Launch& what, int failure, int filter)
      : launch_(what), failure_(failure), filter_(filter), landlock_(what.landlock) {}

  [[noreturn]] void become(char* const* argv, char* const* environment) {
    const pid_t judge = getppid();
    try_to("setsid", setsid());
    for (const int door : launch_.cgroup_doors) try_to("cgroup", write(door, "0", 1));
    place_descriptors();
    set_limits();
    if (launch_.user != 0) change_user();
    // After the change of user, which would undo it. A judge that died before is noticed by
    // getppid.
    try_to("prctl", prctl(PR_SET_PDEATHSIG, SIGKILL));
    if (getppid() != judge) _exit(127);
    try_to("chdir", chdir(launch_.folder.c_str()));
    reset_signals();
    if (!launch_.bubblewrap) drop_rights();
    execve(argv[0], argv, environment);
    give_up("exec");
  }

 private:
  [[noreturn]] void give_up(const char* step) {
    const Failure failure{step, errno};
    (void)!write(failure_, &failure, sizeof failure);
    _exit(127);
  }
  long try_to(const char* step, long result) {
    if (result < 0) give_up(step);
    return result;
  }

  /// Moves them out of the way of one another first, then down to the places that are promised.
  void place_descriptors() {
    constexpr int above = 16;
    const int null = int(try_to("open", open("/dev/null", O_RDONLY | O_CLOEXEC)));
    const bool asked = launch_.questions >= 0;
    std::array from{asked ? launch_.questions : null, asked ? launch_.answers : launch_.output,
                    launch_.output, filter_};
    for (int* descriptor : {&from[0], &from[1], &from[2], &from[3], &failure_, &landlock_})
      if (*descriptor >= 0) *descriptor = int(try_to("dup", fcntl(*descriptor, F_DUPFD, above)));
    int first = 0;
    for (; first < int(from.size()) && from[std::size_t(first)] >= 0; ++first)
      try_to("dup", dup2(from[std::size_t(first)], first));
    if (close_range(unsigned(first), ~0U, CLOSE_RANGE_CLOEXEC) == 0) return;
    constexpr int most = 65536;  // Linux before 5.11
    for (int descriptor = first; descriptor < most; ++descriptor)
      fcntl(descriptor, F_SETFD, FD_CLOEXEC);
  }

  void limit(__rlimit_resource resource, rlim_t most) { limit(resource, most, most); }
  void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
    rlimit now;
    try_to("getrlimit", getrlimit(resource, &now));
    hard = std::min(now.rlim_max, hard);  // no right to raise it
    const rlimit wanted{std::min(soft, hard), hard};
    try_to("setrlimit", setrlimit(resource, &wanted));
  }

  void set_limits() {
    const Limits& limits = launch_.limits;
    constexpr rlim_t stack = 8 << 20, files = 64;
    // SIGXCPU says what it was; a second later comes what no program can ignore.
    const rlim_t seconds = rlim_t(std::ceil(limits.cpu_seconds));
    limit(RLIMIT_CPU, seconds, seconds + 1);
    limit(RLIMIT_AS, limits.memory_bytes);
    limit(RLIMIT_FSIZE, limits.file_bytes);
    limit(RLIMIT_STACK, stack);  // so that too deep a recursion fails at the same depth everywhere
    limit(RLIMIT_NOFILE, files);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_MEMLOCK, 0);
    limit(RLIMIT_MSGQUEUE, 0);
    if (launch_.processes >= 0) limit(RLIMIT_NPROC, rlim_t(launch_.processes));
  }

  /// By system calls: the library's functions would tell threads that are not here.
  void change_user() {
    const uid_t user = launch_.user;
    try_to("setgroups", syscall(SYS_setgroups, 0, nullptr));
    try_to("setresgid", syscall(SYS_setresgid, user, user, user));
    try_to("setresuid", syscall(SYS_setresuid, user, user, user));
  }

  void drop_rights() {
    try_to("no_new_privs", prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0));
    if (landlock_ >= 0) try_to("Landlock", landlock_restrict(landlock_));
    if (!launch_.filter) return;
    sock_fprog program{static_cast<unsigned short>(launch_.filter->size()),
                       const_cast<sock_filter*>(launch_.filter->data())};
    try_to("seccomp", prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program));
  }

  static void reset_signals() {
    for (int number = 1; number < NSIG; ++number) std::signal(number, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
  }

  const Launch& launch_;
  int failure_, filter_, landlock_;
};

/// A file in memory, for bwrap to read.
Descriptor file_of(const std::vector<sock_filter>& filter) {
  Descriptor file(memfd_create("filter", MFD_CLOEXEC));
  const std::size_t size = filter.size() * sizeof(sock_filter);
  if (pwrite(file.number(), filter.data(), size, 0) != ssize_t(size))
    throw Error("memfd_create", std::generic_category().message(errno));
  return file;
}

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

}  // namespace

pid_t launch(const Launch& launch) {
  Pipe failures = make_pipe();
  const std::vector<char*> argv = pointers(launch.argv), environment = pointers(launch.environment);
  const Descriptor filter =
      launch.bubblewrap && launch.filter ? file_of(*launch.filter) : Descriptor();
  const pid_t child = fork();
  if (child < 0) throw Error("fork", std::generic_category().message(errno));
  if (child == 0)
    Child(launch, failures.write.number(), filter.number()).become(argv.data(), environment.data());
  failures.write.close();
  Failure failure{};
  ssize_t size;
  do size = read(failures.read.number(), &failure, sizeof failure);
  while (size < 0 && errno == EINTR);
  if (size != sizeof failure) return child;  // exec closed the pipe
  waitpid(child, nullptr, 0);
  throw Error(launch.argv[0], std::string("cannot be started: ") + failure.step + ": " +
                                  std::generic_category().message(failure.number));
}

}  // namespace scanlit::sandbox
