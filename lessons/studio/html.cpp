#include "lessons/studio/html.h"

#include "lessons/studio/pages/page.h"
#include "lessons/studio/tradeoff/temporary_folder.h"

namespace scanlit::studio {
namespace {

std::string base64(const std::string& bytes) {
  static constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? unsigned(static_cast<unsigned char>(bytes[k])) : 0u;
    };
    const unsigned three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (int k = 0; k < 4; ++k)
      text += i + std::size_t(k) <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The length of the UTF-8 sequence of more than one byte at `at`, and what it encodes; 0: it is
/// none, or too long for what it encodes, or a surrogate.
std::size_t sequence_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(at);
  const std::size_t size = first >= 0xc2 && first < 0xe0   ? 2
                           : first >= 0xe0 && first < 0xf0 ? 3
                           : first >= 0xf0 && first < 0xf5 ? 4
                                                           : 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  const unsigned second = byte(at + 1);
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
      (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
    return 0;
  // The other control characters (C1), which some terminals obey.
  return first == 0xc2 && second < 0xa0 ? 0 : size;
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const auto code = static_cast<unsigned char>(c);
    switch (c) {
      case '&': escaped += "&amp;"; continue;
      case '<': escaped += "&lt;"; continue;
      case '>': escaped += "&gt;"; continue;
      case '"': escaped += "&quot;"; continue;
      case '\'': escaped += "&#39;"; continue;
      default: break;
    }
    if (code >= 0x80) {
      const std::size_t size = sequence_at(text, at);
      escaped += size == 0 ? "\xef\xbf\xbd" : std::string(text.substr(at, size));
      at += size == 0 ? 0 : size - 1;
    } else {
      escaped += (code < 0x20 && c != '\n' && c != '\t') || code == 0x7f ? "\xef\xbf\xbd"
                                                                         : std::string(1, c);
    }
  }
  return escaped;
}

std::string png_url(const Framebuffer& framebuffer) {
  const TemporaryFolder folder;
  const std::string name = folder.file("picture.png");
  write_image(name, framebuffer);
  return "data:image/png;base64," + base64(read_text(name));
}

}  // namespace scanlit::studio
