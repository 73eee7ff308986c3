// What a submitted program may try to read, write, reach and become while it answers, on every
// combination of layers that this machine can show.
#include <unistd.h>

#include <fstream>

#include "tests/assignments/hostile_program.h"

namespace scanlit::test {
namespace {

namespace fs = std::filesystem;

class HostileReach : public Hostile {};

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

TEST_P(HostileReach, ReadsNoSecrets) {
  if (!GetParam().uid) return;  // hidden tests are refused then
  const Secret hidden(closed);
  const std::string judge = "/proc/" + std::to_string(getpid());
  EXPECT_EQ(program(reader({hidden.file(), judge + "/environ", judge + "/mem", "/etc/shadow"}))
                .answer()
                .output,
            "");
}

TEST_P(HostileReach, ReadsNothingBesideTheAllowList) {
  if (!GetParam().landlock && !GetParam().bubblewrap) return;  // files' modes alone decide
  const Secret careless(open_to_all);
  EXPECT_EQ(program(reader({careless.file(), "/etc/passwd", "/proc/self/status", "/dev/zero"}))
                .answer()
                .output,
            "");
}

TEST_P(HostileReach, WritesNothing) {
  if (!GetParam().uid) return;  // the folder is the program's own user's
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

TEST_P(HostileReach, LeavesNoFilesElsewhere) {
  if (!GetParam().landlock && !GetParam().bubblewrap) return;  // /tmp is everybody's
  HostileProgram litter = program(headers + R"(
int main() {
  for (const char* name : {"/tmp/scanlit-litter", "/dev/shm/scanlit-litter", "/var/tmp/scanlit-litter"})
    if (open(name, O_CREAT | O_WRONLY, 0666) >= 0) fputs(name, stderr);
})");
  EXPECT_EQ(litter.answer().output, "");
}

TEST_P(HostileReach, KillsNobody) {
  if (!GetParam().uid) return;  // it is the judge's own user
  HostileProgram killer = program(headers +
                                  "int main() { for (int parent = getppid(), i = 0; i < "
                                  "1000; ++i) { kill(parent, SIGKILL); kill(-1, SIGKILL); } }");
  killer.answer();
  SUCCEED();  // or nobody would be here to say so
}

TEST_P(HostileReach, NoSocketsAndNoNamespaces) {
  if (!GetParam().seccomp) return;  // no filter of system calls
  HostileProgram caller = program("#include <sched.h>\n#include <sys/ptrace.h>\n" + headers + R"(
int main() {
  if (socket(AF_INET, SOCK_STREAM, 0) >= 0) fputs("socket ", stderr);
  if (socket(AF_UNIX, SOCK_STREAM, 0) >= 0) fputs("unix ", stderr);
  if (unshare(CLONE_NEWUSER) == 0) fputs("unshare ", stderr);
  if (ptrace(PTRACE_TRACEME, 0, 0, 0) == 0) fputs("ptrace ", stderr);
})");
  EXPECT_EQ(caller.answer().output, "");
}

TEST_P(HostileReach, GainsNoRights) {
  HostileProgram climber = program(headers + R"(
int main() {
  if (setuid(0) == 0 && geteuid() == 0) fputs("I am root", stderr);
  execl("/usr/bin/su", "su", "-c", "echo I am root", nullptr);
})");
  if (!GetParam().uid) return;  // it is the judge's own user
  EXPECT_EQ(climber.answer(impatient()).output.find("I am root"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Layers, HostileReach, testing::ValuesIn(shown_layers()), name_of_layers);

}  // namespace
}  // namespace scanlit::test
