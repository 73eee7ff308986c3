// What the plug-ins of OpenImageIO write through.
#pragma once

#include <OpenImageIO/filesystem.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>

namespace scanlit {

/// Some plug-ins report success on a full disk, so the first failure is noted here, with its
/// reason. Its type is not "file", for then the JPEG plug-in would hand the FILE itself to libjpeg,
/// which ends the whole program when a write fails.
class CheckedStream final : public OIIO::Filesystem::IOFile {
 public:
  explicit CheckedStream(std::FILE* file) : IOFile(file, Write) {}
  const char* proxytype() const override { return "checked"; }
  bool seek(std::int64_t offset) override {  // writes what is buffered
    return checked(IOFile::seek(offset), true);
  }
  std::size_t write(const void* bytes, std::size_t size) override {
    return checked(IOFile::write(bytes, size), size);
  }
  std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t offset) override {
    return checked(IOFile::pwrite(bytes, size, offset), size);
  }
  int write_errno() const { return write_errno_; }

 private:
  std::size_t checked(std::size_t written, std::size_t size) {
    if (written < size && write_errno_ == 0) write_errno_ = errno != 0 ? errno : EIO;
    return written;
  }
  int write_errno_ = 0;
};

}  // namespace scanlit
