// The layer `uid`: a user number of its own for each submission.
#pragma once

#include <sys/types.h>

#include "lessons/assignments/sandbox/launch.h"

namespace scanlit::sandbox {

/// The range has no purpose on Linux, in distributions or in systemd ("Users, Groups, UIDs and GIDs
/// on systemd Systems", table "Summary": 60578 to 61183 unused), and lies below 65536: containers
/// whose user namespace maps only that many have it.
constexpr uid_t first_user = 60600, user_count = 500;

/// One of these numbers, nobody else's on this machine while it lives. Judges that see one
/// another's processes should see the same /run/scanlit, where numbers are locked: a judge in a
/// chroot of its own kills what another one runs, should both come upon the same number.
class UserLease {
 public:
  /// Takes a free one, and kills what a judge that died has left of it. Throws Error where
  /// all are taken. Wants root.
  UserLease();
  ~UserLease() { kill_all(); }
  UserLease(const UserLease&) = delete;

  uid_t user() const { return user_; }

  /// Every process of that user, also where it has left its session, in one system call: a fork
  /// bomb cannot outrun it. Returns when all are gone. The caller has reaped its own children.
  void kill_all() const;

 private:
  Descriptor lock_;
  uid_t user_ = 0;
};

}  // namespace scanlit::sandbox
