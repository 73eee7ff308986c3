// Whether files are what they were: FNV-1a, 64 bits (Fowler, Noll, Vo, 1991), to tell versions
// apart, not to withstand anybody.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace scanlit::studio {

class Fingerprint {
 public:
  /// Each piece with its length: "ab", "c" is not "a", "bc".
  Fingerprint& add(std::string_view piece);
  /// All of a file; nothing where it cannot be read.
  Fingerprint& add_file(const std::filesystem::path& file);
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  void take(std::string_view bytes);
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace scanlit::studio
