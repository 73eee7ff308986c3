#include "lessons/assignments/judge/program.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <span>

#include "lessons/assignments/answer/protocol.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {

namespace fs = std::filesystem;
using answer::MessageHead;

namespace {

constexpr const char* program_name = "answers";

/// The submission's file. What is not a regular file of reasonable size is not read at all: a link
/// may lead anywhere, a pipe may keep a reader waiting for ever.
std::string read_submitted(const fs::path& file, std::string& complaint) {
  constexpr off_t largest = 1 << 20;
  const int descriptor = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  const std::string name = file.filename().string();
  struct stat status {};
  if (descriptor < 0 || fstat(descriptor, &status) != 0) {
    complaint = errno == ELOOP ? name + " is a link" : "there is no file " + name;
    if (descriptor >= 0) close(descriptor);
    return {};
  }
  if (!S_ISREG(status.st_mode)) complaint = name + " is no regular file";
  if (status.st_size > largest) complaint = name + " is larger than 1 MiB";
  std::string text;
  char buffer[4096];
  for (ssize_t count; complaint.empty() && off_t(text.size()) <= largest &&
                      (count = read(descriptor, buffer, sizeof buffer)) > 0;)
    text.append(buffer, std::size_t(count));
  close(descriptor);
  return text;
}

void write_file(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << text).flush()) throw Error(file.string(), "cannot be written");
}

std::string compiler() {
  for (const char* path : {"/usr/bin/c++", "/usr/bin/g++", "/usr/bin/clang++"})
    if (access(path, X_OK) == 0) return path;
  throw Error("no C++ compiler is installed: there is no /usr/bin/c++");
}

/// Without names that are others in each run: the sandbox's folder, and the compiler's temporary
/// files, as in "/tmp/ccA1b2C3.o".
std::string lasting_words(std::string log, const fs::path& scratch) {
  const std::string folder = scratch.string() + "/", temporary = "/tmp/";
  for (const std::string& each : {folder, temporary})
    for (std::size_t at = 0; (at = log.find(each + "cc", at)) != log.npos; ++at)
      log.replace(at, each.size(), "");
  for (std::size_t at = 0; (at = log.find(folder, at)) != log.npos;) log.erase(at, folder.size());
  constexpr std::size_t random = 6;
  for (std::size_t at = 0; (at = log.find("cc", at)) != log.npos; at += 2) {
    const std::size_t end = at + 2 + random;
    const bool temporary_name =
        end < log.size() && log[end] == '.' &&
        std::all_of(log.begin() + std::ptrdiff_t(at) + 2, log.begin() + std::ptrdiff_t(end),
                    [](unsigned char c) { return std::isalnum(c); });
    if (temporary_name) log.erase(at + 2, random);
  }
  return log;
}

}  // namespace

const std::vector<std::string>& compiler_flags() {
  static const std::vector<std::string> flags{
      "-std=c++20",      "-O2",   "-march=x86-64-v2", "-ffp-contract=off",
      "-fno-math-errno", "-Wall", "-Wextra",          "-Wno-unused-parameter"};
  return flags;
}

Build build(const Assignment& assignment, std::uint64_t seed, const fs::path& submission,
            sandbox::Sandbox& sandbox) {
  Build result;
  // As a file: it may lead to another's submission, or to the solution.
  if (fs::is_symlink(submission)) result.message = "the submission's folder is a link";
  if (!result.message.empty()) return result;
  const std::string text = read_submitted(submission / assignment.file, result.message);
  if (!result.message.empty()) return result;
  const fs::path folder = sandbox.scratch();
  for (const Made& made : support_files(assignment, seed))
    write_file(folder / made.name, made.text);
  write_file(folder / assignment.file, text);

  std::vector<std::string> argv{compiler()};
  argv.insert(argv.end(), compiler_flags().begin(), compiler_flags().end());
  argv.push_back("-I.");
  if (!assignment.is_model()) argv.push_back(assignment.file);
  for (const char* word : {"main.cpp", "-o", program_name}) argv.push_back(word);
  const sandbox::Outcome outcome = sandbox.run(argv);
  result.log = lasting_words(outcome.output, folder);
  result.good = outcome.good() && fs::is_regular_file(fs::symlink_status(folder / program_name));
  if (!result.good)
    result.message = outcome.end == sandbox::Outcome::End::exited
                         ? assignment.file + " does not compile; the compiler's words are below"
                         : "compiling " + assignment.file + ": the compiler " +
                               describe(outcome, sandbox.limits());
  return result;
}

// ------------------------------------------------------------------------------- the conversation

void ProgramRespondent::send(int kind, const Numbers& numbers) {
  const MessageHead head{answer::message_magic, kind, sequence_,
                         std::uint32_t(numbers.integers.size()),
                         std::uint32_t(numbers.reals.size())};
  std::vector<std::byte> bytes;
  const auto append = [&](const auto& values) {
    const auto more = std::as_bytes(std::span(values));
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  append(std::array{head});
  append(numbers.integers);
  append(numbers.reals);
  conversation_->send(bytes);
}

Numbers ProgramRespondent::receive(int& kind, const AnswerSize& size) {
  MessageHead head{};
  conversation_->receive(std::as_writable_bytes(std::span(&head, 1)));
  if (head.magic != answer::message_magic || head.sequence != sequence_)
    throw Unanswered("what came back is not an answer to what was asked");
  const bool counter = head.kind == (head.kind | answer::counter_question);
  if (!counter && head.kind != kind)
    throw Unanswered("what came back is not an answer to what was asked");
  kind = head.kind;
  const auto check = [](const char* what, std::size_t count, std::size_t least, std::size_t most) {
    if (count < least || count > most)
      throw Unanswered("the answer holds " + std::to_string(count) + " " + what +
                       (least == most ? ", not " : "; there may be ") + std::to_string(most));
  };
  constexpr std::size_t most_asked = 1 << 16;
  check("whole numbers", head.integers, counter ? 0 : size.least_integers,
        counter ? most_asked : size.most_integers);
  check("real numbers", head.reals, counter ? 0 : size.least_reals,
        counter ? most_asked : size.most_reals);
  Numbers numbers;
  numbers.integers.resize(head.integers), numbers.reals.resize(head.reals);
  conversation_->receive(std::as_writable_bytes(std::span(numbers.integers)));
  conversation_->receive(std::as_writable_bytes(std::span(numbers.reals)));
  for (const double real : numbers.reals)
    if (!std::isfinite(real))
      throw Unanswered(std::isnan(real) ? "the answer holds NaN: somewhere 0 is divided by 0, or a "
                                          "root is taken of a negative number"
                                        : "the answer holds infinity: somewhere is divided by 0");
  return numbers;
}

Numbers ProgramRespondent::ask(int kind, const Numbers& question, const AnswerSize& size,
                               const Counsel& counsel) {
  try {
    if (!conversation_) {
      std::vector<std::string> argv = command_;
      argv.push_back((sandbox_.scratch() / program_name).string());
      conversation_.emplace(sandbox_.start(argv));
    }
    ++sequence_;
    send(kind, question);
    // Who asks back for ever takes the judge's time, not its own.
    constexpr int patience = 1 << 20;
    for (int asked_back = 0;; ++asked_back) {
      if (asked_back > patience) throw Unanswered("your program asks back without end");
      int answered = kind;
      Numbers numbers = receive(answered, size);
      if (answered == kind) return numbers;
      if (!counsel) throw Unanswered("your program asked something back where nothing is to ask");
      send(answered, counsel(answered - answer::counter_question, numbers));
    }
  } catch (const sandbox::Silent& error) {
    keep(error.outcome.output);
    throw Unanswered(std::string("your program ") + error.what(), false);
  } catch (const sandbox::NoAnswer& error) {
    keep(error.outcome.output);
    throw Unanswered(std::string("your program ") + error.what());
  }
}

void ProgramRespondent::keep(const std::string& output) {
  constexpr std::size_t enough = 1 << 20;
  if (printed_.size() < enough) printed_ += output;
  conversation_.reset();
}

void ProgramRespondent::start_anew() {
  if (conversation_) keep(conversation_->finish().output);
}

std::string ProgramRespondent::printed() {
  start_anew();
  return printed_;
}

std::string ProgramRespondent::hang_up() {
  return conversation_ ? conversation_->hang_up().output : printed_;
}

}  // namespace scanlit::assignments
