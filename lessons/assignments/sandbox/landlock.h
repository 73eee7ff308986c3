// The layer `landlock`: the files that can be opened.
#pragma once

#include <filesystem>
#include <vector>

#include "lessons/assignments/sandbox/launch.h"

namespace scanlit::sandbox {

/// Rules by which `readable` can be read and executed, and `writable` (empty: nothing) changed,
/// too; no network, no signals to and no abstract sockets of others, as far as the kernel knows
/// these. Paths that do not exist are left out. Empty where the kernel has no Landlock.
Descriptor landlock_rules(const std::vector<std::filesystem::path>& readable,
                          const std::filesystem::path& writable);

/// From now on, for the calling process and its children. Wants no_new_privs. -1 and errno.
long landlock_restrict(int rules);

/// What GCC and a program's start need to read; no /usr/share, where a course's data may be.
const std::vector<std::filesystem::path>& toolchain();

}  // namespace scanlit::sandbox
