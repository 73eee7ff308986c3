// golden_tests                  compares every case with its reference (GoogleTest's options apply)
// golden_tests --bless NAME...  makes the pictures of these cases the references
// golden_tests --list           prints the names
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ostream>
#include <string_view>

#include "rasterizer/error.h"
#include "tests/golden/golden.h"

namespace scanlit::golden {

// Else GoogleTest prints the bytes of a failed case.
void PrintTo(const Case& golden_case, std::ostream* out) { *out << golden_case.name; }

namespace {

const std::filesystem::path references = SCANLIT_SOURCE_DIR "/tests/golden/references";
const std::filesystem::path report_folder = SCANLIT_SOURCE_DIR "/tests/out/golden";

// Writes the page once all cases have run.
class Report : public testing::Environment {
 public:
  void add(Result result) { results_.push_back(std::move(result)); }
  void TearDown() override {
    if (results_.empty()) return;
    write_report(report_folder, results_);
    std::printf("Pictures: %s\n", (report_folder / "index.html").c_str());
  }

 private:
  std::vector<Result> results_;
};
Report* const report =
    static_cast<Report*>(testing::AddGlobalTestEnvironment(new Report));  // GoogleTest owns it

class Golden : public testing::TestWithParam<Case> {};

TEST_P(Golden, MatchesItsReference) {
  Result result = check(GetParam(), references);
  for (const std::string& problem : result.comparison.problems)
    ADD_FAILURE() << problem << "\nTo accept the new picture: tests/bless " << result.name;
  report->add(std::move(result));
}

INSTANTIATE_TEST_SUITE_P(Image, Golden, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

void bless_all(const std::vector<std::string>& names) {
  std::vector<const Case*> chosen;
  std::vector<std::string> known;
  for (const Case& golden_case : cases()) known.push_back(golden_case.name);
  for (const std::string& name : names) {
    const auto found = std::ranges::find(cases(), name, &Case::name);
    if (found == cases().end())
      throw Error("unknown golden image '" + name + "'" + did_you_mean(name, known));
    chosen.push_back(&*found);
  }
  for (const Case* golden_case : chosen)
    std::fputs(bless(*golden_case, references).c_str(), stdout);
}

}  // namespace
}  // namespace scanlit::golden

int main(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "--list") {
    for (const auto& golden_case : scanlit::golden::cases()) std::puts(golden_case.name.c_str());
    return 0;
  }
  if (command == "--bless") {
    try {
      scanlit::golden::bless_all({argv + 2, argv + argc});
      return 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "error: %s\n", error.what());
      return 2;
    }
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
