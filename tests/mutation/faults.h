// The table of planted faults: tests/mutation/faults/*.txt.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scanlit::mutation {

/// A test program of the mutation build, and which of its tests are run.
struct Catcher {
  std::string program;  // "clip": tests/unit/clip_test.cpp
  std::string filter;   // GoogleTest's; "*": all
};

struct Fault {
  std::filesystem::path file;         // in the source tree
  std::string kind;                   // "wrong comparison"
  std::string meaning;                // "a corner exactly on a plane is lost"
  std::string original, replacement;  // text of the file
  std::vector<Catcher> catchers;      // one after the other, until one notices
  std::string equivalent{};           // why nothing can notice; empty: something must
  bool in_sample = false;
};

/// Reads a folder's tables, in the order of their names. Lines are
///
///   in FILE                        what follows is of this file
///   - KIND | MEANING | TESTS       a fault; with * in place of -, one of the sample
///     ORIGINAL                     text that stands in the file once
///     REPLACEMENT
///   = REASON                       why the fault before is none: no picture shows it
///   # ...                          a remark
///
/// TESTS are names of tests/unit/NAME_test.cpp, or NAME:FILTER. Throws std::runtime_error, naming
/// file and line, for anything else.
std::vector<Fault> read_faults(const std::filesystem::path& folder);

/// A tree's file with the fault in it. Throws std::runtime_error where the original text does not
/// stand there exactly once.
std::string with_fault(const Fault& fault, const std::filesystem::path& tree);

/// A fault in a tree, for as long as it lives. Throws likewise.
class Planted {
 public:
  Planted(const Fault& fault, const std::filesystem::path& tree);
  Planted(const Planted&) = delete;
  Planted& operator=(const Planted&) = delete;
  ~Planted();

 private:
  std::filesystem::path file_;
  std::string text_;
};

}  // namespace scanlit::mutation
