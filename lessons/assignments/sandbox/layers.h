// The layers between a program that nobody trusts and the rest of the machine.
//
//   always        cleared environment, closed descriptors, a session of its own that is killed at
//                 the end, limits of processor time, memory, file size and open files (setrlimit),
//                 no_new_privs: no program of another user's rights (set-user-ID) can be started.
//   uid           a user number that nothing else on the machine has, one per submission: files of
//                 the judge with mode 0700 cannot be opened, its processes cannot be signalled or
//                 traced, the number of processes is limited, and everything of that user is killed
//                 at the end, wherever it hides. Wants root.
//   seccomp       only system calls that a compiler or an answer needs are there: no sockets,
//                 ptrace, namespaces, mounts, keys, io_uring, bpf; for an answer no fork either.
//   landlock      files beside the toolchain, the package and scratch cannot be opened, even where
//                 their mode lets everybody read them. Linux 5.13.
//   bubblewrap    there are no such files: a root of its own from an allow-list of mounts, with
//                 processes, network and System V memory of its own. It takes Landlock's place,
//                 which forbids mounts. Wants user namespaces, which containers often refuse.
//   cgroup        number and memory of all processes of a submission together. A limit of memory
//                 holds for each process alone otherwise. Wants a control group that is ours: the
//                 root, or one that its manager delegated.
//
// Root's own programs would keep root's file access in any of these, and no limit on the number of
// processes binds root: without `uid` hidden tests are therefore not run at all.
#pragma once

#include <string>
#include <vector>

namespace scanlit::sandbox {

struct Layers {
  bool uid = false, seccomp = false, landlock = false, bubblewrap = false;
  bool cgroup_processes = false, cgroup_memory = false;
  bool operator==(const Layers&) const = default;
};

/// What this machine allows, found out by trying, once.
const Layers& available();

/// Of the kernel, also where bubblewrap is in its place.
bool has_landlock();

/// Those that are in force: "own uid, seccomp, bubblewrap"; "limits alone" where none is.
std::string in_force(const Layers& layers);
/// Those that are not, with the reason: "Landlock: bubblewrap is in its place".
std::vector<std::string> not_in_force(const Layers& layers);

}  // namespace scanlit::sandbox
