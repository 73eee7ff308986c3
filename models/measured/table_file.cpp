#include "models/measured/table_file.h"

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>

#include "rasterizer/error.h"
#include "rasterizer/image/output_file.h"

namespace scanlit::models {
namespace {

static_assert(std::endian::native == std::endian::little,
              "tables are read as they lie in the file");

struct Plane {
  const char* name;
  double Rgb<double>::*channel;
};
constexpr Plane planes[] = {
    {"red", &Rgb<double>::r}, {"green", &Rgb<double>::g}, {"blue", &Rgb<double>::b}};

std::uintmax_t size_of_regular(const std::filesystem::path& file, const std::string& name) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw Error(name, "there is no such file");
  if (error) throw Error(name, error.message());
  if (std::filesystem::is_directory(status)) throw Error(name, "is a folder, not a table");
  if (!std::filesystem::is_regular_file(status)) throw Error(name, "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw Error(name, error.message());
  return size;
}

}  // namespace

TableFile::TableFile(const std::filesystem::path& file)
    : name_(file.string()), size_(size_of_regular(file, name_)), stream_(file, std::ios::binary) {
  if (!stream_) throw Error(name_, "cannot be opened for reading");
}

void TableFile::read(void* to, std::size_t bytes) {
  if (!stream_.read(static_cast<char*>(to), std::streamsize(bytes)))
    throw Error(name_, "cannot be read");
}

std::vector<Rgb<double>> TableFile::read_planes(std::size_t count) {
  std::vector<Rgb<double>> entries(count);
  std::vector<double> numbers(count);
  for (const Plane& plane : planes) {
    const auto first_byte = std::size_t(stream_.tellg());
    read(numbers.data(), count * sizeof(double));
    for (std::size_t i = 0; i < count; ++i) {
      if (!(std::abs(numbers[i]) <= max_table_entry)) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "%s entry %zu (counted from 0; at byte %zu) is %g; entries are finite and "
                      "within +-%g",
                      plane.name, i, first_byte + i * sizeof(double), numbers[i], max_table_entry);
        throw Error(name_, text);
      }
      entries[i].*plane.channel = numbers[i];
    }
  }
  return entries;
}

void write_table(const std::filesystem::path& file, std::span<const std::int32_t> header,
                 const std::vector<Rgb<double>>& entries) {
  OutputFile output(file);
  int write_errno = 0;
  const auto write = [&](const void* from, std::size_t bytes) {
    if (write_errno == 0 && std::fwrite(from, 1, bytes, output.stream()) != bytes)
      write_errno = errno != 0 ? errno : EIO;
  };
  if (!header.empty()) write(header.data(), header.size_bytes());  // UTIA has none
  std::vector<double> numbers(entries.size());
  for (const Plane& plane : planes) {
    for (std::size_t i = 0; i < entries.size(); ++i) numbers[i] = entries[i].*plane.channel;
    write(numbers.data(), numbers.size() * sizeof(double));
  }
  output.commit(write_errno);
}

}  // namespace scanlit::models
