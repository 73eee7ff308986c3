// The layer `seccomp`: the system calls that are there.
#pragma once

#include <linux/filter.h>

#include <vector>

namespace scanlit::sandbox {

/// For seccomp(SECCOMP_SET_MODE_FILTER) and bwrap --seccomp. A call that is not on the list is
/// answered as a kernel too old to know it would (ENOSYS), for which libraries have other ways.
/// Empty where Scanlit was built without libseccomp. `may_fork`: other processes and threads.
const std::vector<sock_filter>& seccomp_filter(bool may_fork);

}  // namespace scanlit::sandbox
