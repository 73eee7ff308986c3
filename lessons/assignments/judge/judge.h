// From a student's folder to a verdict.
#pragma once

#include <filesystem>
#include <functional>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/rubric.h"
#include "lessons/assignments/judge/verdict.h"
#include "lessons/assignments/sandbox/sandbox.h"

namespace scanlit::assignments {

struct JudgeOptions {
  std::filesystem::path scratch;  // a folder to build in; what is made there is removed
  sandbox::Limits build_limits{.cpu_seconds = 30, .memory_bytes = 1 << 30};
  sandbox::Limits limits{};                // of one process, which answers one test
  sandbox::Layers layers{};                // asked for; each must be available
  std::function<void(double)> progress{};  // called with 0..1
};

/// Builds the assignment's file of the folder and puts the program to the rubric's tests, each
/// twice, each in a fresh process: the lower score counts. Whatever the submission does, the
/// verdict holds every test of the rubric; what cannot be built scores 0 everywhere. Throws Error
/// where the fault is not the submission's: no compiler, no room in the scratch folder, an unknown
/// part.
Verdict judge(const Assignment& assignment, const std::filesystem::path& submission,
              const Rubric& rubric, const JudgeOptions& options);

}  // namespace scanlit::assignments
