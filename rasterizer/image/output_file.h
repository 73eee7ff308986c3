// A file that appears whole or not at all: written beside its place, then renamed into it.
#pragma once

#include <cstdio>
#include <filesystem>

namespace scanlit {

class OutputFile {
 public:
  /// Opens an empty file under a temporary name in the folder of the target, which is `name` or,
  /// where that is a link, what it leads to. Throws Error with `name`: the folder is missing or not
  /// writable, the target is a folder or a device.
  explicit OutputFile(const std::filesystem::path& name);
  /// Removes the temporary file, unless it was committed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::FILE* stream() const { return stream_; }

  /// Closes the file and puts it in the target's place. Throws Error with `name` if any write to
  /// stream() failed (`write_errno`, where the caller knows it, says why).
  void commit(int write_errno = 0);

 private:
  std::filesystem::path name_, target_, temporary_;
  std::FILE* stream_ = nullptr;
};

}  // namespace scanlit
