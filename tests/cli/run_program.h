// Runs `scanlit` in an empty folder of its own and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scanlit::test {

struct Outcome {
  int exit_code;  // -N where signal N ended it
  std::string out, err;
};

/// A folder that is made empty and removed with all it holds.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& file, const std::string& text) const;
  std::string read(const std::string& file) const;
  std::vector<std::string> files() const;  // sorted names

  /// Runs `scanlit` here, through a shell that splits `arguments` and applies `before`, such as
  /// "ulimit -v 500000;". Output goes through files outside of the folder.
  Outcome run(const std::string& arguments, const std::string& before = "") const;

 private:
  std::filesystem::path path_;
};

}  // namespace scanlit::test
