// What a submitted file may try while it is compiled, on every combination of layers that this
// machine can show: no secret comes out, and it ends.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/assignments/hostile_program.h"

namespace scanlit::test {
namespace {

namespace fs = std::filesystem;

/// A folder as the judge has it, with a secret in it that compiles.
struct Hidden {
  explicit Hidden(int mode) {
    std::string name = (fs::temp_directory_path() / "scanlit-hidden-XXXXXX").string();
    folder = mkdtemp(name.data());
    fs::permissions(folder, fs::perms(mode));
    std::ofstream(folder / "hidden.csv") << "int the_answer_is_42;\n";
  }
  ~Hidden() { fs::remove_all(folder); }
  std::string file() const { return (folder / "hidden.csv").string(); }

  fs::path folder;
};

class HostileBuild : public testing::TestWithParam<sandbox::Layers> {
 protected:
  static sandbox::Limits tight() {
    sandbox::Limits limits = for_compiler();
    limits.cpu_seconds = 2;
    limits.memory_bytes = 256 << 20;
    limits.file_bytes = 4 << 20;
    return limits;
  }
  sandbox::Outcome compile(const std::string& source) const {
    sandbox::Sandbox box(fs::temp_directory_path(), {}, tight(), GetParam());
    return test::compile(box, source);
  }
  bool only_what_is_allowed() const { return GetParam().landlock || GetParam().bubblewrap; }
};

TEST_P(HostileBuild, OfWhatCannotBeCompiledIsTold) {
  const sandbox::Outcome outcome = compile("int main() { return does_not_exist; }");
  EXPECT_FALSE(outcome.good());
  EXPECT_NE(outcome.output.find("does_not_exist"), std::string::npos);
  EXPECT_FALSE(compile("").good());  // no main()
}

TEST_P(HostileBuild, IncludesNoSecret) {
  if (!GetParam().uid && !only_what_is_allowed()) return;  // hidden tests are refused then
  const Hidden closed(0700), careless(0755);
  for (const Hidden* hidden : {&closed, &careless}) {
    if (hidden == &careless && !only_what_is_allowed()) continue;
    const std::string secret = "\"" + hidden->file() + "\"";
    for (const std::string& source :
         {"#include " + secret + "\nint main() { return the_answer_is_42; }",
          "asm(\".incbin \\" + secret.substr(0, secret.size() - 1) + "\\\"\");\nint main() {}",
          "#if !__has_include(" + secret + ")\n#error none\n#endif\nint main() {}"}) {
      const sandbox::Outcome outcome = compile(source);
      EXPECT_FALSE(outcome.good()) << source;
      EXPECT_EQ(outcome.output.find("int the_answer"), std::string::npos) << outcome.output;
    }
  }
}

TEST_P(HostileBuild, IncludesNoEndlessFile) {
  EXPECT_FALSE(compile("#include \"/dev/zero\"\nint main() {}").good());
  EXPECT_FALSE(compile("#include \"/dev/stdin\"\n").good());
  EXPECT_FALSE(compile("#include \"source.cpp\"\nint main() {}").good());
}

TEST_P(HostileBuild, ProgramOfGigabytes) {
  EXPECT_FALSE(compile("asm(\".fill 1000000000, 8, 1\");\nint main() {}").good());
  EXPECT_FALSE(compile("char a[1 << 30] = {1};\nint main() {}").good());
}

TEST_P(HostileBuild, BombsForTheCompiler) {
  if (!thorough() && GetParam() != sandbox::available()) return;  // in --long
  EXPECT_FALSE(compile("constexpr long f() { long s = 0; for (long i = 0; i < 250000; ++i)\n"
                       "  for (int j = 0; j < 100; ++j) s += j; return s; }\n"
                       "template <int N> constexpr long g() { return f() + g<N - 1>(); }\n"
                       "template <> constexpr long g<0>() { return 0; }\n"
                       "constexpr long all = g<800>();\nint main() {}")
                   .good());
  EXPECT_FALSE(compile("template <class A, class B> struct P {};\n"
                       "template <int N, class T> struct D : D<N - 1, P<T, T>> {};\n"
                       "template <class T> struct D<0, T> { static void f() { T::none(); } };\n"
                       "int main() { D<40, int>::f(); }")
                   .good());
  std::string macros = "#define A0 0,0,0,0,0,0,0,0,0,0\n";
  for (int i = 1; i < 10; ++i) {
    macros += "#define A" + std::to_string(i) + " ";
    for (int k = 0; k < 10; ++k) macros += (k ? ", A" : "A") + std::to_string(i - 1);
    macros += "\n";
  }
  EXPECT_FALSE(compile(macros + "int a[] = {A9};\nint main() {}").good());
}

INSTANTIATE_TEST_SUITE_P(Layers, HostileBuild, testing::ValuesIn(shown_layers()), name_of_layers);

}  // namespace
}  // namespace scanlit::test
