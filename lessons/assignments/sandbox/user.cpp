#include "lessons/assignments/sandbox/user.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace scanlit::sandbox {
namespace {

constexpr const char* locks = "/run/scanlit";

/// In a child. kill(-1) reaches whoever shares any of the sender's numbers, so all three must be
/// the student's before it is called: with one of them still root's it would end the machine's
/// services.
[[noreturn]] void kill_as(uid_t user) {
  uid_t real = 0, effective = 0, saved = 0;
  const bool changed =
      syscall(SYS_setresuid, user, user, user) == 0 && getresuid(&real, &effective, &saved) == 0;
  if (!changed || real != user || effective != user || saved != user) _exit(1);
  kill(-1, SIGKILL);
  _exit(0);
}

/// Buries dead processes of `user`: without a parent they become the judge's, see UserLease(), and
/// count to the user's limit until then. How many are left?
int bury(uid_t user) {
  int left = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    struct stat status;
    if (stat(entry.path().c_str(), &status) != 0 || status.st_uid != user) continue;
    const pid_t process = pid_t(std::strtol(entry.path().filename().c_str(), nullptr, 10));
    left += process <= 0 || waitpid(process, nullptr, WNOHANG) != process;
  }
  return left;
}

}  // namespace

UserLease::UserLease() {
  if (geteuid() != 0) throw Error("own uid", "wants root");
  // In many containers process 1 buries nobody.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  std::filesystem::create_directories(locks);
  // Not all from the first on: a judge in another root does not see these locks.
  const uid_t start = uid_t(getpid());
  for (uid_t i = 0; i < user_count; ++i) {
    const uid_t user = first_user + (start + i) % user_count;
    const std::string name = std::string(locks) + "/uid-" + std::to_string(user);
    Descriptor lock(open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!lock) throw Error(name, "cannot be opened");
    if (flock(lock.number(), LOCK_EX | LOCK_NB) != 0) continue;
    lock_ = std::move(lock);
    user_ = user;
    kill_all();
    return;
  }
  throw Error(locks, "all " + std::to_string(user_count) + " user numbers are taken");
}

void UserLease::kill_all() const {
  if (user_ < first_user) return;
  // The child is of the student's user for a moment, in which a student's program may kill it.
  constexpr int tries = 100;
  for (int i = 0; i < tries; ++i) {
    const pid_t child = fork();
    if (child == 0) kill_as(user_);
    int status = 0;
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (child > 0 && WIFEXITED(status)) break;
  }
  constexpr int most = 5000;  // of a kernel that is busy with killing
  constexpr useconds_t pause_us = 1000;
  for (int i = 0; i < most && bury(user_) > 0; ++i) usleep(pause_us);
}

}  // namespace scanlit::sandbox
