// A file that appears whole or not at all: written beside its place, then renamed into it.
#pragma once

#include <cstdio>
#include <filesystem>

namespace scanlit {

class OutputFile {
 public:
  /// Opens an empty file under a temporary name in the target's folder. Throws Error naming the
  /// target: its folder is missing or not writable, the target is a folder.
  explicit OutputFile(const std::filesystem::path& target);
  /// Removes the temporary file, unless it was committed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::FILE* stream() const { return stream_; }

  /// Closes the file and gives it its name, replacing what had that name. Throws Error naming the
  /// target if any write to stream() failed (`write_errno`, where the caller knows it, says why).
  void commit(int write_errno = 0);

 private:
  std::filesystem::path target_, temporary_;
  std::FILE* stream_ = nullptr;
};

}  // namespace scanlit
