// A student's program, from the file that was handed in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lessons/assignments/judge/files.h"
#include "lessons/assignments/judge/respondent.h"
#include "lessons/assignments/sandbox/sandbox.h"

namespace scanlit::assignments {

/// What came of compiling.
struct Build {
  bool good = false;
  std::string log;      // what the compiler said: text that students can shape
  std::string message;  // in the judge's words, where it is not good
};

/// Copies the assignment's one file of the submission into the sandbox, without following links,
/// at most 1 MiB of it, beside the judge's own files, and compiles. Throws Error where the fault is
/// not the submission's.
Build build(const Assignment& assignment, std::uint64_t seed,
            const std::filesystem::path& submission, sandbox::Sandbox& sandbox);

/// The flags of build(), which a student's own build has too: the portable level, so that the
/// verdict does not depend on the processor.
const std::vector<std::string>& compiler_flags();

/// The program that build() made, started when it is asked first, as the argument of another one
/// if `under` names one.
class ProgramRespondent final : public Respondent {
 public:
  explicit ProgramRespondent(sandbox::Sandbox& sandbox, std::vector<std::string> under = {})
      : sandbox_(sandbox), command_(std::move(under)) {}

  Numbers ask(int kind, const Numbers& question, const AnswerSize& size,
              const Counsel& counsel = {}) override;
  void start_anew() override;

  /// Ends the program; what it has printed, since it was made: text of any kind.
  std::string printed();

  /// Asks nothing more; what it has printed until it ended by itself.
  std::string hang_up();

 private:
  void send(int kind, const Numbers& numbers);
  void keep(const std::string& output);
  Numbers receive(int& kind, const AnswerSize& size);

  sandbox::Sandbox& sandbox_;
  std::vector<std::string> command_;
  std::optional<sandbox::Conversation> conversation_;
  std::uint32_t sequence_ = 0;
  std::string printed_;
};

}  // namespace scanlit::assignments
