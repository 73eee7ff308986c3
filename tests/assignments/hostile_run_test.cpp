// What a submitted program may use up while it answers, on every combination of layers that this
// machine can show: the judge goes on, and nothing is left behind.
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "tests/assignments/hostile_program.h"

namespace scanlit::test {
namespace {

using End = sandbox::Outcome::End;

class HostileUse : public Hostile {};

TEST_P(HostileUse, EndlessLoop) {
  HostileProgram endless = program("int main() { for (volatile int i = 0;;) i = 1; }");
  EXPECT_EQ(endless.answer().end, End::out_of_cpu_time);
}

TEST_P(HostileUse, EndlessLoopBeforeMainAndAfterIt) {
  if (!thorough() && GetParam() != sandbox::available()) return;  // in --long
  const std::string loop = "for (volatile int i = 0;;) i = 1;";
  HostileProgram before = program("struct S { S() { " + loop + " } } s; int main() {}");
  EXPECT_EQ(before.answer().end, End::out_of_cpu_time);
  HostileProgram after =
      program("#include <stdlib.h>\nint main() { atexit([] { " + loop + " }); }");
  EXPECT_EQ(after.answer().end, End::out_of_cpu_time);
}

TEST_P(HostileUse, IgnoresSignals) {
  if (!thorough() && GetParam() != sandbox::available()) return;  // in --long
  HostileProgram deaf = program(headers + R"(
int main() {
  for (int i = 1; i < 64; ++i) signal(i, SIG_IGN);
  for (volatile int i = 0;;) i = 1;
})");
  const sandbox::Outcome outcome = deaf.answer();
  EXPECT_EQ(outcome.end, End::killed);
  EXPECT_EQ(outcome.code, SIGKILL);
}

TEST_P(HostileUse, Sleeps) {
  HostileProgram sleeper = program("#include <unistd.h>\nint main() { for (;;) pause(); }");
  EXPECT_EQ(sleeper.answer(impatient()).end, End::out_of_wall_time);
}

TEST_P(HostileUse, SleepsBeforeEachAnswer) {
  HostileProgram dawdler = program(
      "#include <unistd.h>\nint main() { for (int n; read(0, &n, 4) == 4;) { usleep(100000); "
      "if (write(1, &n, 4) != 4) return 1; } }");
  sandbox::Limits limits = mild();
  limits.wall_seconds = 0.2;
  sandbox::Conversation conversation = dawdler.start(limits);
  const auto ask_forever = [&] {
    for (int number = 1;;) {
      conversation.send(std::as_bytes(std::span(&number, 1)));
      conversation.receive(std::as_writable_bytes(std::span(&number, 1)));
    }
  };
  EXPECT_THROW(ask_forever(), sandbox::Silent);
}

TEST_P(HostileUse, CrashesOrExits) {
  EXPECT_EQ(program("int main() { __builtin_trap(); }").answer().end, End::killed);
  EXPECT_EQ(program("int f(int i) { volatile int a[999]; a[0] = f(i + 1); return a[0]; }\n"
                    "int main() { return f(0); }")
                .answer()
                .end,
            End::killed);
  for (const char* way : {"exit(0)", "_exit(0)", "quick_exit(0)"}) {
    const sandbox::Outcome outcome =
        program("#include <stdlib.h>\n#include <unistd.h>\nint main() { " + std::string(way) +
                "; }")
            .answer();
    EXPECT_TRUE(outcome.good());  // it ended well, and gave no answer
  }
}

TEST_P(HostileUse, ForkBomb) {
  if (!GetParam().uid && !GetParam().cgroup_processes) return;  // no limit of processes
  const bool least = GetParam() == sandbox::Layers{.uid = true};
  if (!thorough() && !least && GetParam() != sandbox::available()) return;  // in --long
  HostileProgram bomb = program("#include <unistd.h>\nint main() { for (;;) fork(); }");
  sandbox::Limits limits = impatient();
  limits.wall_seconds = 0.2;
  EXPECT_FALSE(bomb.run(limits).good());
  // In a conversation there is nothing to fork for.
  limits.processes = 1;
  EXPECT_NE(bomb.answer(limits).end, End::exited);
}

TEST_P(HostileUse, NumberOfProcessesIsLimited) {
  if (!GetParam().uid && !GetParam().cgroup_processes) return;  // no limit of processes
  HostileProgram forks = program(headers + R"(
int main() {
  int children = 0;
  while (children < 100) {
    const pid_t child = fork();
    if (child < 0) break;
    if (child == 0) { setsid(); for (;;) pause(); }
    ++children;
  }
  printf("%d", children);
})");
  const int children = std::stoi(forks.run().output);
  EXPECT_GE(children, 1);
  EXPECT_LT(children, mild().processes + 2);
}

TEST_P(HostileUse, DaemonsDieToo) {
  if (!GetParam().uid && !GetParam().bubblewrap) return;  // who leaves the session survives
  HostileProgram daemon = program(headers + R"(
int main() {
  if (fork() == 0) { setsid(); if (fork() == 0) for (;;) pause(); _exit(0); }
  wait(nullptr);
})");
  EXPECT_TRUE(daemon.run().good());
}

constexpr const char* eat = R"(
int megabytes = 0;
while (megabytes < 1024) {
  char* more = (char*)malloc(1 << 20);
  if (!more) break;
  memset(more, 1, 1 << 20);
  ++megabytes;
}
)";

TEST_P(HostileUse, MemoryOfOneProcess) {
  HostileProgram glutton = program(headers + "int main() {" + eat + "printf(\"%d\", megabytes); }");
  const sandbox::Outcome outcome = glutton.run();
  if (outcome.end == End::exited) {  // else the control group has killed it
    EXPECT_LE(std::stoi("0" + outcome.output), 256);
  }
}

TEST_P(HostileUse, MemoryOfManyProcesses) {
  if (!GetParam().uid && !GetParam().cgroup_processes) return;  // no limit of processes
  HostileProgram gluttons = program(headers + "int main() { for (int i = 0; i < 20; ++i) fork();" +
                                    eat + "printf(\"%d \", megabytes); fflush(stdout); pause(); }");
  sandbox::Limits limits = impatient();
  limits.memory_bytes = 64 << 20;
  limits.processes = 4;
  std::istringstream counts(gluttons.run(limits).output);
  int total = 0;
  for (int megabytes; counts >> megabytes;) total += megabytes;
  EXPECT_LE(total, 4 * 64);
}

TEST_P(HostileUse, EndlessOutput) {
  HostileProgram loud = program(
      "#include <unistd.h>\nchar text[1 << 16];\nint main() { for (;;) write(2, text, sizeof "
      "text); }");
  const sandbox::Outcome outcome = loud.answer();
  EXPECT_EQ(outcome.end, End::too_much_output);
  EXPECT_EQ(outcome.output.size(), mild().output_bytes);
}

TEST_P(HostileUse, FilesAreLimited) {
  HostileProgram writer = program(headers + R"(
int main() {
  signal(SIGXFSZ, SIG_IGN);
  const int file = open("large", O_CREAT | O_WRONLY, 0600);
  static char block[1 << 16];
  long size = 0;
  for (ssize_t written; size < (64 << 20) && (written = write(file, block, sizeof block)) > 0;) size += written;
  printf("%ld", size);
})");
  EXPECT_LE(std::stol(writer.run().output), long(mild().file_bytes));
}

INSTANTIATE_TEST_SUITE_P(Layers, HostileUse, testing::ValuesIn(shown_layers()), name_of_layers);

}  // namespace
}  // namespace scanlit::test
