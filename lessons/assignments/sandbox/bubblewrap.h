// The layer `bubblewrap`: a root of its own from an allow-list of mounts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scanlit::sandbox {

/// Processes that bwrap itself is, beside the program: they count to the user's limit.
constexpr int bubblewrap_processes = 2;

/// `program` behind bwrap: the toolchain and `readable` read-only, `scratch` read-only or writable,
/// a /tmp of at most `tmp_bytes` if that is not 0, null and urandom as the only devices; no /proc,
/// unless it is among `readable`: then that of its own processes. `filter` is the descriptor of a
/// seccomp filter that bwrap reads, or -1.
std::vector<std::string> bubblewrapped(const std::vector<std::string>& program,
                                       const std::vector<std::filesystem::path>& readable,
                                       const std::filesystem::path& scratch, bool writable,
                                       std::uint64_t tmp_bytes, int filter);

}  // namespace scanlit::sandbox
