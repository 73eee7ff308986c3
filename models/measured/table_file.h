// Files of measured tables: planes of float64, red, green, blue, after a header of few bytes or
// none. Little-endian, as published. What comes from such a file is finite, and as much as was
// asked for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/vec.h"

namespace scanlit::models {

class TableFile {
 public:
  /// Opens it. Throws Error with the file's name: there is none, it is no regular file, unreadable.
  explicit TableFile(const std::filesystem::path& file);

  const std::string& name() const { return name_; }
  std::uintmax_t size() const { return size_; }  // bytes

  /// The next bytes.
  void read(void* to, std::size_t bytes);
  /// The next three planes of `count` numbers. Throws Error, with the entry and its byte, for what
  /// is not finite or beyond +-max_table_entry.
  std::vector<Rgb<double>> read_planes(std::size_t count);

 private:
  std::string name_;
  std::uintmax_t size_;
  std::ifstream stream_;
};

/// Far above any f_r, and far enough below the largest float that products with it stay finite.
constexpr double max_table_entry = 1e30;

/// Header and planes into a file that appears whole or not at all. Throws Error.
void write_table(const std::filesystem::path& file, std::span<const std::int32_t> header,
                 const std::vector<Rgb<double>>& entries);

}  // namespace scanlit::models
