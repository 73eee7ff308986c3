#include "rasterizer/image/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "rasterizer/error.h"

namespace scanlit {
namespace {

std::string reason(int error_number) { return std::generic_category().message(error_number); }

/// Where a link leads, so that it stays a link.
std::filesystem::path resolved(const std::filesystem::path& target) {
  std::error_code nothing_there;
  const auto place = std::filesystem::canonical(target, nothing_there);
  return nothing_there ? target : place;
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& name) : name_(name), target_(resolved(name)) {
  std::error_code error;
  const auto folder = target_.has_parent_path() ? target_.parent_path() : ".";
  if (!std::filesystem::exists(folder, error))
    throw Error(name_.string(), "there is no folder '" + folder.string() + "'");
  const auto status = std::filesystem::status(target_, error);
  if (status.type() == std::filesystem::file_type::directory)
    throw Error(name_.string(), "is a folder; the name of a file is needed");
  if (error && status.type() != std::filesystem::file_type::not_found)
    throw Error(name_.string(), "cannot create a file there: " + error.message());
  // A pipe or device would be replaced by a file.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw Error(name_.string(), "is not a regular file");
  // The temporary name does not grow with the target's, which may be as long as names can be. "x"
  // refuses a name that is taken, also by what a killed process of the same number left behind.
  for (int attempt = 0; !stream_ && attempt < 1000; ++attempt) {
    temporary_ = folder / (".scanlit-" + std::to_string(getpid()) + "-" + std::to_string(attempt));
    stream_ = std::fopen(temporary_.c_str(), "wbx");
    if (!stream_ && errno != EEXIST) break;
  }
  if (!stream_) throw Error(name_.string(), "cannot create a file there: " + reason(errno));
}

OutputFile::~OutputFile() {
  if (stream_) std::fclose(stream_);
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void OutputFile::commit(int write_errno) {
  // The stream remembers any failed write, even one that its writer did not look at.
  bool failed = std::ferror(stream_) != 0 || write_errno != 0;
  if (std::fclose(std::exchange(stream_, nullptr)) != 0 && !failed) {
    failed = true;
    write_errno = errno;
  }
  if (failed)
    throw Error(name_.string(),
                "cannot write: " + (write_errno ? reason(write_errno) : "writing failed"));
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) throw Error(name_.string(), "cannot write: " + error.message());
  temporary_.clear();
}

}  // namespace scanlit
