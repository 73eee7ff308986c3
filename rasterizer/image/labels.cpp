#include "rasterizer/image/labels.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "rasterizer/image/openimageio.h"

namespace scanlit {
namespace {

bool readable(const std::string& file) {
  return openimageio::functions().text_width(file, "x", 12).has_value();
}

/// Plain sans serifs with Greek letters, the first found anywhere under the folder.
std::string font_under(const std::filesystem::path& folder) {
  const char* const names[] = {"DejaVuSans.ttf", "NotoSans-Regular.ttf",
                               "LiberationSans-Regular.ttf", "FreeSans.ttf"};
  std::vector<std::string> files(std::size(names));
  std::error_code error;
  using Walk = std::filesystem::recursive_directory_iterator;
  const auto options = std::filesystem::directory_options::skip_permission_denied;
  for (Walk entry(folder, options, error); !error && entry != Walk(); entry.increment(error))
    for (std::size_t i = 0; i < files.size(); ++i)
      if (entry->path().filename() == names[i]) files[i] = entry->path().string();
  for (const std::string& file : files)
    if (!file.empty() && readable(file)) return file;
  return "";
}

/// A question mark for each character (UTF-8) beyond ASCII.
std::string ascii(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (const auto byte = static_cast<unsigned char>(c); byte < 0x80)
      result += c;
    else if (byte >= 0xc0)  // the first of several bytes
      result += '?';
  return result;
}

}  // namespace

std::optional<Font> Font::find() {
  if (const char* named = std::getenv("SCANLIT_FONT"))
    return std::filesystem::is_regular_file(named) && readable(named) ? std::optional(Font(named))
                                                                      : std::nullopt;
  std::vector<std::filesystem::path> folders{"/usr/share/fonts", "/usr/local/share/fonts"};
  if (const char* home = std::getenv("HOME"))
    for (const char* folder : {".fonts", ".local/share/fonts"})
      folders.push_back(std::filesystem::path(home) / folder);
  for (const auto& folder : folders)
    if (const std::string file = font_under(folder); !file.empty()) return Font(file);
  return std::nullopt;
}

int Font::width(const std::string& text, int size) const {
  if (text.empty()) return 0;
  return openimageio::functions().text_width(file_, ascii(text), size).value_or(0);
}

std::string Font::fitted(const std::string& text, int size, int max_width) const {
  if (width(text, size) <= max_width) return text;
  for (std::size_t kept = text.size() / 2; kept > 0; --kept) {
    const std::string shorter = text.substr(0, kept) + "..." + text.substr(text.size() - kept);
    if (width(shorter, size) <= max_width) return shorter;
  }
  return "";
}

void Font::draw(Framebuffer& picture, int x, int y, const std::string& text, int size, Align align,
                const Rgb<float>& colour) const {
  openimageio::functions().draw_text(picture, file_, x, y, ascii(text), size, align, colour);
}

}  // namespace scanlit
