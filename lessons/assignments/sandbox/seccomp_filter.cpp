#include "lessons/assignments/sandbox/seccomp_filter.h"

#if SCANLIT_SECCOMP

#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "lessons/assignments/sandbox/launch.h"

namespace scanlit::sandbox {
namespace {

/// What the C library, GCC, its assembler and linker use. Files are for the other layers to guard.
constexpr const char* allowed[] = {
    // files
    "access", "chdir", "chmod", "close", "close_range", "copy_file_range", "creat", "dup", "dup2",
    "dup3", "faccessat", "faccessat2", "fadvise64", "fallocate", "fchmod", "fchmodat", "fcntl",
    "fdatasync", "fgetxattr", "flock", "fstat", "fstatfs", "fsync", "ftruncate", "getcwd",
    "getdents", "getdents64", "ioctl", "link", "linkat", "lseek", "lstat", "mkdir", "mkdirat",
    "newfstatat", "open", "openat", "pipe", "pipe2", "pread64", "preadv", "pwrite64", "pwritev",
    "read", "readlink", "readlinkat", "readv", "rename", "renameat", "renameat2", "rmdir",
    "sendfile", "stat", "statfs", "statx", "symlink", "symlinkat", "truncate", "umask", "unlink",
    "unlinkat", "utimensat", "write", "writev",
    // memory
    "brk", "madvise", "membarrier", "mincore", "mlock", "mmap", "mprotect", "mremap", "msync",
    "munlock", "munmap",
    // itself
    "alarm", "arch_prctl", "capget", "execve", "exit", "exit_group", "getegid", "geteuid", "getgid",
    "getgroups", "getpgid", "getpgrp", "getpid", "getppid", "getpriority", "getrandom", "getresgid",
    "getresuid", "getrlimit", "getrusage", "getsid", "gettid", "getuid", "prctl", "prlimit64",
    "rseq", "sched_getaffinity", "sched_getparam", "sched_getscheduler", "sched_yield",
    "set_robust_list", "set_tid_address", "setitimer", "setpgid", "setrlimit", "setsid", "sysinfo",
    "times", "uname", "wait4", "waitid",
    // time, signals to threads (which abort() sends; kill() could end all of a user's processes),
    // waiting
    "clock_getres", "clock_gettime", "clock_nanosleep", "epoll_create1", "epoll_ctl", "epoll_pwait",
    "epoll_wait", "eventfd2", "futex", "gettimeofday", "nanosleep", "pause", "poll", "ppoll",
    "pselect6", "restart_syscall", "rt_sigaction", "rt_sigpending", "rt_sigprocmask",
    "rt_sigreturn", "rt_sigsuspend", "rt_sigtimedwait", "select", "sigaltstack", "tgkill", "time",
    "tkill"};

void allow(scmp_filter_ctx filter, const char* call) {
  const int number = seccomp_syscall_resolve_name(call);
  if (number >= 0) seccomp_rule_add(filter, SCMP_ACT_ALLOW, number, 0);  // else not of this machine
}

/// clone() makes threads, processes and namespaces; clone3() would, too, with flags in memory that
/// no filter can read: it stays unknown, and the C library then calls clone().
void allow_fork(scmp_filter_ctx filter) {
  constexpr scmp_datum_t namespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC |
                                      CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
  allow(filter, "fork");
  allow(filter, "vfork");
  seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(clone), 1,
                   SCMP_A0(SCMP_CMP_MASKED_EQ, namespaces, 0));
}

std::vector<sock_filter> compile(bool may_fork) {
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(ENOSYS));
  if (!filter) return {};
  for (const char* call : allowed) allow(filter, call);
  if (may_fork) allow_fork(filter);
  const Descriptor file(memfd_create("filter", MFD_CLOEXEC));
  const bool written = seccomp_export_bpf(filter, file.number()) == 0;
  seccomp_release(filter);
  const off_t size = written ? lseek(file.number(), 0, SEEK_END) : 0;
  std::vector<sock_filter> program(std::size_t(size) / sizeof(sock_filter));
  if (pread(file.number(), program.data(), std::size_t(size), 0) != size) return {};
  return program;
}

}  // namespace

const std::vector<sock_filter>& seccomp_filter(bool may_fork) {
  static const std::vector<sock_filter> with_fork = compile(true), without = compile(false);
  return may_fork ? with_fork : without;
}

}  // namespace scanlit::sandbox

#else

const std::vector<sock_filter>& scanlit::sandbox::seccomp_filter(bool) {
  static const std::vector<sock_filter> none;
  return none;
}

#endif
