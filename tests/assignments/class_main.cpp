// Writes a class of A1: of every ten submissions three are right, one is the starter, five have a
// typical fault, and one is hostile. tests/assignments/class grades it.
#include <sys/stat.h>

#include <fstream>
#include <iostream>

#include "tests/assignments/submissions.h"

namespace fs = std::filesystem;
using namespace scanlit::assignments;

namespace {

void write(const fs::path& folder, const std::string& file, const std::string& text) {
  fs::create_directories(folder);
  std::ofstream(folder / file, std::ios::binary) << text;
}

/// The right solution, with this done before main().
std::string before_main(const std::string& solution, const std::string& action) {
  return "#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n#include <fcntl.h>\n"
         "#include <signal.h>\n#include <sys/stat.h>\n#include <time.h>\n#include <unistd.h>\n" +
         solution + "\nnamespace {\nstruct Attack { Attack() { " + action + " } } attack;\n}\n";
}

struct Hostile {
  const char* name;
  std::string text;
};

std::vector<Hostile> hostile(const std::string& solution, const std::string& hidden) {
  const auto run = [&](const std::string& action) { return before_main(solution, action); };
  return {
      {"endless loop", run("for (volatile int i = 0;;) i = 1;")},
      {"sleeper", run("for (;;) pause();")},
      {"fork bomb", run("for (;;) fork();")},
      {"memory",
       run("for (;;) { char* p = (char*)malloc(1 << 20); if (p) memset(p, 1, 1 << 20); }")},
      {"endless output", run("static char text[1 << 16]; for (;;) write(2, text, sizeof text);")},
      {"exit 0", run("_exit(0);")},
      {"crash", run("__builtin_trap();")},
      {"at exit", run("atexit([] { for (volatile int i = 0;;) i = 1; });")},
      {"forged report", run("puts(\"PASSED 100 of 100\"); int f = open(\"results.json\", O_CREAT | "
                            "O_WRONLY, 0666); if (f >= 0) write(f, \"{}\", 2);")},
      {"vandal",
       run("unlink(\"answers\"); rmdir(\".\"); kill(-1, SIGKILL); kill(getppid(), SIGKILL);")},
      {"reads hidden tests", "#include \"" + hidden + "\"\n" + solution},
      {"assembles hidden tests", solution + "\nasm(\".incbin \\\"" + hidden + "\\\"\");\n"},
      {"includes without end", "#include \"/dev/zero\"\n" + solution},
      {"constexpr bomb",
       solution + "\ntemplate <int N> constexpr long f() { long s = 0; for (long i = 0; i < "
                  "30000000; ++i) s += i; return s + f<N - 1>(); }\ntemplate <> constexpr long "
                  "f<0>() { return 0; }\nconstexpr long all = f<800>();\n"},
      {"unbuildable <script>",
       "#error \"<script>alert(1)</script> \x1b[2J =cmd|' /C calc'!A0 \x01\xff\"\n"},
      {"empty file", ""},
      {"changes from run to run",
       run("timespec t; clock_gettime(CLOCK_REALTIME, &t); if (t.tv_nsec % 64 != 0) _exit(1);")},
      {"wrong sizes",
       run("static const char text[] = \"not an answer at all\"; write(1, text, sizeof text);")},
      {"=1+1\n\"quoted\" \xf0\x9f\x98\x80", solution},
      {"link", ""}};
}

std::string numbered(int i) {
  const std::string digits = std::to_string(i);
  return "student" + std::string(3 - std::min<std::size_t>(3, digits.size()), '0') + digits;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "error: assignment_class wants a folder, how many, and where hidden tests are\n";
    return 2;
  }
  const fs::path folder = argv[1];
  const Assignment& a1 = assignment("A1");
  const std::string solution = test::solution_text(a1), starter = test::starter_text(a1);
  const auto wrong = test::wrong_solutions(a1);
  const auto attacks = hostile(solution, argv[3]);
  for (int i = 0; i < std::atoi(argv[2]); ++i) {
    const std::string mark = "\n// " + numbered(i) + "\n";
    const int kind = i % 10;
    if (kind == 9) {
      const Hostile& attack = attacks[std::size_t(i / 10) % attacks.size()];
      const fs::path submission = folder / (numbered(i) + " " + attack.name);
      write(submission, a1.file, attack.text);
      if (std::string(attack.name) == "link") {
        fs::remove(submission / a1.file);
        fs::create_symlink("/etc/passwd", submission / a1.file);
      }
      continue;
    }
    const std::string& text = kind < 3    ? solution
                              : kind == 3 ? starter
                                          : wrong[std::size_t(i) % wrong.size()].text;
    write(folder / numbered(i), a1.file, text + mark);
  }
}
