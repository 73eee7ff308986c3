// What a submitted program may try while it answers, on every combination of layers that this
// machine can show: the judge goes on, and nothing is left behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "tests/assignments/hostile_program.h"

namespace scanlit::test {
namespace {

namespace fs = std::filesystem;
using End = sandbox::Outcome::End;

/// A folder as the judge has it, with a secret in it.
class Secret {
 public:
  explicit Secret(fs::perms folder_mode) {
    std::string name = (fs::temp_directory_path() / "scanlit-secret-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    fs::permissions(folder_, folder_mode);
    std::ofstream(file()) << "the-answer-is-42";
  }
  ~Secret() { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "hidden.csv").string(); }
  std::string folder() const { return folder_.string(); }

 private:
  fs::path folder_;
};

constexpr fs::perms closed = fs::perms::owner_all, open_to_all = fs::perms(0755);

class Hostile : public testing::TestWithParam<sandbox::Layers> {
 protected:
  HostileProgram program(const std::string& source) const {
    return HostileProgram(source, GetParam());
  }
};

const std::string headers =
    "#include <errno.h>\n#include <initializer_list>\n#include <fcntl.h>\n#include <signal.h>\n"
    "#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n"
    "#include <sys/socket.h>\n#include <sys/stat.h>\n"
    "#include <sys/wait.h>\n#include <unistd.h>\n";

TEST_P(Hostile, EndlessLoop) {
  HostileProgram endless = program("int main() { for (volatile int i = 0;;) i = 1; }");
  EXPECT_EQ(endless.answer().end, End::out_of_cpu_time);
}

TEST_P(Hostile, EndlessLoopBeforeMainAndAfterIt) {
  if (!thorough() && GetParam() != sandbox::available()) GTEST_SKIP() << "in --long";
  const std::string loop = "for (volatile int i = 0;;) i = 1;";
  HostileProgram before = program("struct S { S() { " + loop + " } } s; int main() {}");
  EXPECT_EQ(before.answer().end, End::out_of_cpu_time);
  HostileProgram after =
      program("#include <stdlib.h>\nint main() { atexit([] { " + loop + " }); }");
  EXPECT_EQ(after.answer().end, End::out_of_cpu_time);
}

TEST_P(Hostile, IgnoresSignals) {
  if (!thorough() && GetParam() != sandbox::available()) GTEST_SKIP() << "in --long";
  HostileProgram deaf = program(headers + R"(
int main() {
  for (int i = 1; i < 64; ++i) signal(i, SIG_IGN);
  for (volatile int i = 0;;) i = 1;
})");
  const sandbox::Outcome outcome = deaf.answer();
  EXPECT_EQ(outcome.end, End::killed);
  EXPECT_EQ(outcome.code, SIGKILL);
}

TEST_P(Hostile, Sleeps) {
  HostileProgram sleeper = program("#include <unistd.h>\nint main() { for (;;) pause(); }");
  EXPECT_EQ(sleeper.answer(impatient()).end, End::out_of_wall_time);
}

TEST_P(Hostile, CrashesOrExits) {
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

TEST_P(Hostile, ForkBomb) {
  if (!GetParam().uid && !GetParam().cgroup_processes) GTEST_SKIP() << "no limit of processes";
  HostileProgram bomb = program("#include <unistd.h>\nint main() { for (;;) fork(); }");
  sandbox::Limits limits = impatient();
  limits.wall_seconds = 0.2;
  EXPECT_FALSE(bomb.run(limits).good());
  // In a conversation there is nothing to fork for.
  limits.processes = 1;
  EXPECT_NE(bomb.answer(limits).end, End::exited);
}

TEST_P(Hostile, NumberOfProcessesIsLimited) {
  if (!GetParam().uid && !GetParam().cgroup_processes) GTEST_SKIP() << "no limit of processes";
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

TEST_P(Hostile, DaemonsDieToo) {
  if (!GetParam().uid && !GetParam().bubblewrap) GTEST_SKIP() << "who leaves the session survives";
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

TEST_P(Hostile, MemoryOfOneProcess) {
  HostileProgram glutton = program(headers + "int main() {" + eat + "printf(\"%d\", megabytes); }");
  const sandbox::Outcome outcome = glutton.run();
  if (outcome.end == End::exited) {  // else the control group has killed it
    EXPECT_LE(std::stoi("0" + outcome.output), 256);
  }
}

TEST_P(Hostile, MemoryOfManyProcesses) {
  if (!GetParam().uid && !GetParam().cgroup_processes) GTEST_SKIP() << "no limit of processes";
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

TEST_P(Hostile, EndlessOutput) {
  HostileProgram loud = program(
      "#include <unistd.h>\nchar text[1 << 16];\nint main() { for (;;) write(2, text, sizeof "
      "text); }");
  const sandbox::Outcome outcome = loud.answer();
  EXPECT_EQ(outcome.end, End::too_much_output);
  EXPECT_EQ(outcome.output.size(), mild().output_bytes);
}

TEST_P(Hostile, FilesAreLimited) {
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

/// Says which of `paths` it could read, and what it read of them.
std::string reader(const std::vector<std::string>& paths) {
  std::string source = headers + "int main() {";
  for (const std::string& path : paths)
    source += "{ char text[99] = {}; const int file = open(\"" + path +
              "\", O_RDONLY); if (file >= 0 && read(file, text, 98) > 0) fprintf(stderr, "
              "\"%s: %s\\n\", \"" +
              path + "\", text); }";
  return source + "}";
}

TEST_P(Hostile, ReadsNoSecrets) {
  if (!GetParam().uid) GTEST_SKIP() << "hidden tests are refused then";
  const Secret hidden(closed);
  const std::string judge = "/proc/" + std::to_string(getpid());
  EXPECT_EQ(program(reader({hidden.file(), judge + "/environ", judge + "/mem", "/etc/shadow"}))
                .answer()
                .output,
            "");
}

TEST_P(Hostile, ReadsNothingBesideTheAllowList) {
  if (!GetParam().landlock && !GetParam().bubblewrap) GTEST_SKIP() << "files' modes alone decide";
  const Secret careless(open_to_all);
  EXPECT_EQ(program(reader({careless.file(), "/etc/passwd", "/proc/self/status", "/dev/zero"}))
                .answer()
                .output,
            "");
}

TEST_P(Hostile, WritesNothing) {
  if (!GetParam().uid) GTEST_SKIP() << "the folder is the program's own user's";
  const Secret hidden(closed);
  HostileProgram vandal = program(headers + R"(
int main() {
  for (const char* name : {"results.json", "../results.json", ")" +
                                  hidden.folder() +
                                  R"(/results.json", "program"}) {
    const int file = open(name, O_CREAT | O_WRONLY | O_TRUNC, 0666);
    if (file >= 0) fprintf(stderr, "wrote %s\n", name);
    if (unlink(name) == 0) fprintf(stderr, "deleted %s\n", name);
  }
  if (rmdir("../work") == 0 || rename("../work", "../w") == 0) fputs("moved", stderr);
  if (symlink("/etc/shadow", "link") == 0) fputs("linked", stderr);
  fputs("{\"tests\": [{\"score\": 100}]}\n", stderr);
})");
  EXPECT_EQ(vandal.answer().output, "{\"tests\": [{\"score\": 100}]}\n");
  EXPECT_TRUE(fs::exists(vandal.program()));
}

TEST_P(Hostile, LeavesNoFilesElsewhere) {
  if (!GetParam().landlock && !GetParam().bubblewrap) GTEST_SKIP() << "/tmp is everybody's";
  HostileProgram litter = program(headers + R"(
int main() {
  for (const char* name : {"/tmp/scanlit-litter", "/dev/shm/scanlit-litter", "/var/tmp/scanlit-litter"})
    if (open(name, O_CREAT | O_WRONLY, 0666) >= 0) fputs(name, stderr);
})");
  EXPECT_EQ(litter.answer().output, "");
}

TEST_P(Hostile, KillsNobody) {
  if (!GetParam().uid) GTEST_SKIP() << "it is the judge's own user";
  HostileProgram killer = program(headers +
                                  "int main() { for (int parent = getppid(), i = 0; i < "
                                  "1000; ++i) { kill(parent, SIGKILL); kill(-1, SIGKILL); } }");
  killer.answer();
  SUCCEED();  // or nobody would be here to say so
}

TEST_P(Hostile, NoSocketsAndNoNamespaces) {
  if (!GetParam().seccomp) GTEST_SKIP() << "no filter of system calls";
  HostileProgram caller = program("#include <sched.h>\n#include <sys/ptrace.h>\n" + headers + R"(
int main() {
  if (socket(AF_INET, SOCK_STREAM, 0) >= 0) fputs("socket ", stderr);
  if (socket(AF_UNIX, SOCK_STREAM, 0) >= 0) fputs("unix ", stderr);
  if (unshare(CLONE_NEWUSER) == 0) fputs("unshare ", stderr);
  if (ptrace(PTRACE_TRACEME, 0, 0, 0) == 0) fputs("ptrace ", stderr);
})");
  EXPECT_EQ(caller.answer().output, "");
}

TEST_P(Hostile, GainsNoRights) {
  HostileProgram climber = program(headers + R"(
int main() {
  if (setuid(0) == 0 && geteuid() == 0) fputs("I am root", stderr);
  execl("/usr/bin/su", "su", "-c", "echo I am root", nullptr);
})");
  if (!GetParam().uid) GTEST_SKIP() << "it is the judge's own user";
  EXPECT_EQ(climber.answer(impatient()).output.find("I am root"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Layers, Hostile, testing::ValuesIn(shown_layers()),
                         [](const auto& layers) {
                           std::string name;
                           for (const char c : sandbox::in_force(layers.param))
                             name += std::isalnum(c) ? c : '_';
                           return name;
                         });

}  // namespace
}  // namespace scanlit::test
