// What crosses the pipe between the judge and a student's program: messages of a head and numbers,
// in the machine's own byte order. The judge writes to the program's standard input and reads from
// its standard output.
#pragma once

#include <cstdint>

namespace scanlit::answer {

/// Followed by so many std::int64_t and then so many double.
struct MessageHead {
  std::uint32_t magic;     // message_magic
  std::int32_t kind;       // what is asked; an answer repeats it
  std::uint32_t sequence;  // counts the judge's questions; an answer repeats it
  std::uint32_t integers, reals;
};
static_assert(sizeof(MessageHead) == 20);

constexpr std::uint32_t message_magic = 0x5ca71179;

/// Added to the kind of what the program asks the judge before it answers.
constexpr std::int32_t counter_question = 1 << 30;

/// No message holds more numbers of either kind.
constexpr std::uint32_t most_numbers = 1u << 22;

}  // namespace scanlit::answer
