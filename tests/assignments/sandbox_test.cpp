// What a sandbox promises whatever layers it has: programs run, answer, and end when they must.
#include "lessons/assignments/sandbox/sandbox.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <iostream>

#include "tests/assignments/hostile_program.h"

namespace scanlit::test {
namespace {

using End = sandbox::Outcome::End;

constexpr const char* doubler = R"(
#include <unistd.h>
int main() {
  for (int question; read(0, &question, sizeof question) == sizeof question;) {
    const int answer = 2 * question;
    write(1, &answer, sizeof answer);
  }
}
)";

int ask(sandbox::Conversation& conversation, int question) {
  int answer = 0;
  conversation.send(std::as_bytes(std::span(&question, 1)));
  conversation.receive(std::as_writable_bytes(std::span(&answer, 1)));
  return answer;
}

std::string what_is_said_of(const std::string& source, const sandbox::Limits& limits = mild()) {
  HostileProgram program(source);
  sandbox::Conversation conversation = program.start(limits);
  try {
    ask(conversation, 1);
  } catch (const sandbox::NoAnswer& error) {
    return error.what();
  }
  return "answered";
}

TEST(Sandbox, ProgramIsCompiledAndRuns) {
  HostileProgram program("#include <stdio.h>\nint main() { puts(\"hello\"); return 3; }");
  const sandbox::Outcome outcome = program.run();
  EXPECT_EQ(outcome.end, End::exited);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.output, "hello\n");
}

TEST(Sandbox, ProgramAnswersQuestions) {
  HostileProgram program(doubler);
  sandbox::Conversation conversation = program.start(impatient());
  for (int question = 0; question < 1000; ++question)
    ASSERT_EQ(ask(conversation, question), 2 * question);
  std::vector<int> many(1 << 16, 21);  // more than a pipe holds, while nobody reads the answers
  EXPECT_THROW(conversation.send(std::as_bytes(std::span(many))), sandbox::Silent);
}

TEST(Sandbox, SaysHowAProgramEnded) {
  EXPECT_EQ(what_is_said_of("int main() { return 0; }"), "ended by itself, with exit status 0");
  EXPECT_EQ(what_is_said_of("int main() { __builtin_trap(); }"), "crashed (SIGILL)");
  EXPECT_EQ(what_is_said_of("int main() { for (volatile int i = 0;;) i = 1; }"),
            "needed more than 1 s of processor time");
  EXPECT_EQ(what_is_said_of("#include <unistd.h>\nint main() { pause(); }", impatient()),
            "did nothing for 1 s");
}

TEST(Sandbox, KeepsTheFirstOfMuchOutput) {
  HostileProgram program(
      "#include <stdio.h>\nint main() { for (int i = 0; i < 3000000; ++i) puts(\"ab\"); }");
  const sandbox::Outcome outcome = program.run();
  EXPECT_TRUE(outcome.good());
  EXPECT_EQ(outcome.output.size(), mild().output_bytes);
}

TEST(Sandbox, EnvironmentAndDescriptorsAreCleared) {
  setenv("SECRET_OF_THE_JUDGE", "1", 1);
  HostileProgram program(R"(
#include <fcntl.h>
#include <stdio.h>
extern char** environ;
int main() {
  for (char** e = environ; *e; ++e) puts(*e);
  for (int i = 3; i < 100; ++i) if (fcntl(i, F_GETFD) >= 0) printf("open: %d\n", i);
})");
  const std::string output = program.run().output;
  unsetenv("SECRET_OF_THE_JUDGE");
  EXPECT_EQ(output.find("SECRET"), output.npos) << output;
  EXPECT_EQ(output.find("open:"), output.npos) << output;
}

TEST(Sandbox, ValgrindCountsBehindEachLayer) {
  const std::string valgrind = "/usr/bin/valgrind";
  if (access(valgrind.c_str(), X_OK) != 0) GTEST_SKIP() << "valgrind is not installed";
  for (const sandbox::Layers& layers : shown_layers()) {
    SCOPED_TRACE(sandbox::in_force(layers));
    HostileProgram program(doubler, layers);
    program.box().limits() = for_compiler();
    program.box().limits().memory_bytes += 4ULL << 30;
    program.box().limits().processes = 1;
    program.box().allow_valgrind();
    sandbox::Conversation conversation =
        program.box().start({valgrind, "--tool=callgrind", "--vgdb=no",
                             "--callgrind-out-file=/dev/null", program.program().string()});
    EXPECT_EQ(ask(conversation, 21), 42);
    const std::string output = conversation.hang_up().output;
    EXPECT_NE(output.find("Collected : "), output.npos) << output;
  }
}

TEST(Sandbox, PrintsItsLayers) {
  std::cout << "in force: " << sandbox::in_force(sandbox::available()) << '\n';
  for (const std::string& layer : sandbox::not_in_force(sandbox::available()))
    std::cout << "not in force: " << layer << '\n';
}

TEST(Sandbox, WhatCannotBeStartedIsAnError) {
  sandbox::Sandbox box(std::filesystem::temp_directory_path(), {}, mild(), {});
  EXPECT_THROW(box.run({"/no/such/program"}), Error);
}

}  // namespace
}  // namespace scanlit::test
