#include "lessons/studio/fingerprint.h"

#include <cstdio>
#include <fstream>
#include <vector>

namespace scanlit::studio {

void Fingerprint::take(std::string_view bytes) {
  for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
}

Fingerprint& Fingerprint::add(std::string_view piece) {
  take(std::to_string(piece.size()) + ":");
  take(piece);
  return *this;
}

Fingerprint& Fingerprint::add_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> buffer(1 << 20);
  while (stream.read(buffer.data(), std::streamsize(buffer.size())) || stream.gcount() > 0)
    take({buffer.data(), std::size_t(stream.gcount())});
  return *this;
}

std::string Fingerprint::text() const {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash_));
  return text;
}

}  // namespace scanlit::studio
