// A student's folder: page, starter, rubric, what is needed to build without the judge.
#pragma once

#include <cstdint>
#include <filesystem>

#include "lessons/assignments/judge/assignment.h"

namespace scanlit::assignments {

/// Fills `folder`, which must not exist or be empty. Throws Error, and leaves no folder behind that
/// was not there.
void hand_out(const Assignment& assignment, std::uint64_t seed,
              const std::filesystem::path& folder);

}  // namespace scanlit::assignments
