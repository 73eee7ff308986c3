#include <algorithm>
#include <fstream>
#include <set>

#include "lessons/assignments/grade/run.h"
#include "lessons/assignments/judge/files.h"
#include "lessons/studio/fingerprint.h"

namespace scanlit::assignments {
namespace fs = std::filesystem;
using studio::Fingerprint;

namespace {

/// This program and the libraries of ours that it runs on.
void add_program(Fingerprint& fingerprint) {
  std::set<std::string> files;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const std::size_t path = line.find('/');
    if (path != line.npos && line.find("scanlit", path) != line.npos)
      files.insert(line.substr(path));
  }
  std::error_code none;
  files.insert(fs::read_symlink("/proc/self/exe", none).string());
  for (const std::string& file : files) fingerprint.add_file(file);
}

}  // namespace

std::string package_key(const Assignment& assignment, std::uint64_t seed) {
  Fingerprint fingerprint;
  add_program(fingerprint);
  for (const Made& file : support_files(assignment, seed))
    fingerprint.add(file.name).add(file.text);
  return fingerprint.text();
}

std::string submission_key(const fs::path& submission, const Assignment& assignment) {
  const fs::path file = submission / assignment.file;
  std::error_code none;
  const fs::file_status status = fs::symlink_status(file, none);
  Fingerprint fingerprint;
  fingerprint.add(std::to_string(int(status.type()))).add(fs::is_symlink(submission) ? "link" : "");
  if (!fs::is_regular_file(status)) return fingerprint.text();
  constexpr std::uintmax_t largest = 1 << 20;  // a larger one is not judged at all
  const std::uintmax_t size = fs::file_size(file, none);
  fingerprint.add(std::to_string(size));
  return size <= largest ? fingerprint.add_file(file).text() : fingerprint.text();
}

Result standing(const Result& earlier, const Rubric& rubric, const std::string& key,
                std::vector<RubricTest>& missing) {
  Result kept = earlier;
  kept.tests.clear();
  for (const RubricTest& test : rubric.tests) {
    const std::string test_key = Fingerprint()
                                     .add(key)
                                     .add(std::to_string(rubric.seed))
                                     .add(test.part)
                                     .add(std::to_string(test.questions))
                                     .text();
    const auto found = std::ranges::find(earlier.tests, test_key, &TestResult::key);
    const bool stands = found != earlier.tests.end() && earlier.fault.empty();
    kept.tests.push_back(stands ? *found : TestResult{test.id, test.part, test_key, "", 0});
    kept.tests.back().id = test.id;
    if (!stands) missing.push_back(test);
  }
  std::erase_if(kept.pictures, [&](const JudgedPicture& picture) {  // "A1.6-teapot" is of A1.6
    return std::ranges::none_of(rubric.tests, [&](const RubricTest& test) {
      return picture.name.starts_with(test.part + "-") &&
             std::ranges::find(missing, test.id, &RubricTest::id) == missing.end();
    });
  });
  return kept;
}

}  // namespace scanlit::assignments
