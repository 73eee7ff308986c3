// The judge's questions are read, your functions are called, their answers are sent back. Nothing
// here needs to be understood or changed for an assignment.
//
// Your functions may print: standard output is then standard error, and `scanlit check` shows what
// they print below a test that fails. Standard input is empty.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "answer/protocol.h"

namespace scanlit::answer {

/// Numbers, taken in order.
class Received {
 public:
  std::vector<std::int64_t> integers;
  std::vector<double> reals;

  std::int64_t integer() { return integers.at(next_integer_++); }
  double real() { return reals.at(next_real_++); }

 private:
  std::size_t next_integer_ = 0, next_real_ = 0;
};

/// Numbers to be sent.
struct Sent {
  std::vector<std::int64_t> integers;
  std::vector<double> reals;
};

class Pipe {
 public:
  Pipe() : in_(dup(STDIN_FILENO)), out_(dup(STDOUT_FILENO)) {
    std::fclose(stdin);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // or what is printed last would be lost
  }

  /// False at the end of the conversation.
  bool receive(MessageHead& head, Received& numbers) {
    if (!read_all(&head, sizeof head)) return false;
    numbers = {};
    numbers.integers.resize(head.integers), numbers.reals.resize(head.reals);
    return read_all(numbers.integers.data(), 8 * numbers.integers.size()) &&
           read_all(numbers.reals.data(), 8 * numbers.reals.size());
  }

  void send(std::int32_t kind, std::uint32_t sequence, const Sent& numbers) {
    const MessageHead head{message_magic, kind, sequence, std::uint32_t(numbers.integers.size()),
                           std::uint32_t(numbers.reals.size())};
    std::vector<char> bytes;
    const auto append = [&bytes](const void* from, std::size_t size) {
      const char* const begin = static_cast<const char*>(from);
      bytes.insert(bytes.end(), begin, begin + size);
    };
    append(&head, sizeof head);
    append(numbers.integers.data(), 8 * numbers.integers.size());
    append(numbers.reals.data(), 8 * numbers.reals.size());
    write_all(bytes.data(), bytes.size());
  }

 private:
  bool read_all(void* to, std::size_t size) {
    for (char* at = static_cast<char*>(to); size > 0;) {
      const ssize_t count = read(in_, at, size);
      if (count <= 0) return false;
      at += count, size -= std::size_t(count);
    }
    return true;
  }
  void write_all(const char* from, std::size_t size) {
    while (size > 0) {
      const ssize_t count = write(out_, from, size);
      if (count <= 0) std::_Exit(1);  // nobody listens any more
      from += count, size -= std::size_t(count);
    }
  }

  int in_, out_;
};

/// Of the question being answered, for what asks back.
inline Pipe* pipe_to_judge = nullptr;
inline std::uint32_t present_sequence = 0;

/// Asks the judge, from within a handler.
inline Received ask_judge(std::int32_t kind, const Sent& question) {
  pipe_to_judge->send(kind + counter_question, present_sequence, question);
  MessageHead head;
  Received reply;
  if (!pipe_to_judge->receive(head, reply)) std::_Exit(0);
  return reply;
}

using Handler = void (*)(Received& question, Sent& answer);

struct Served {
  std::int32_t kind;
  Handler handler;
};

/// Answers until the judge hangs up.
inline int serve(std::initializer_list<Served> all) {
  Pipe pipe;
  pipe_to_judge = &pipe;
  MessageHead head;
  Received question;
  while (pipe.receive(head, question)) {
    present_sequence = head.sequence;
    Sent answer;
    for (const Served& each : all)
      if (each.kind == head.kind) each.handler(question, answer);
    pipe.send(head.kind, head.sequence, answer);
  }
  return 0;
}

}  // namespace scanlit::answer
