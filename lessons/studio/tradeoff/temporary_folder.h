// A folder for what is needed for a moment.
#pragma once

#include <filesystem>
#include <string>

namespace scanlit::studio {

/// Made with a name that is nobody else's, and gone at the end with everything in it. Throws Error
/// where none can be made.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace scanlit::studio
