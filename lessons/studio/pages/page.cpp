#include "lessons/studio/pages/page.h"

#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "rasterizer/error.h"
#include "rasterizer/image.h"

namespace scanlit::studio {
namespace {

namespace fs = std::filesystem;

constexpr const char *idea_begins = "// new idea", *idea_ends = "// end of new idea";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t indent_of(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

std::string moved_left(const std::vector<std::string>& lines) {
  std::size_t indent = std::string::npos;
  for (const std::string& line : lines)
    if (!line.empty()) indent = std::min(indent, indent_of(line));
  std::string text;
  for (const std::string& line : lines) text += (line.empty() ? "" : line.substr(indent)) + '\n';
  return text;
}

std::string link_to(const fs::path& folder, const std::string& name) {
  return '[' + page_title(folder, name) + "](" + name + ".md)";
}

double screen_value(float linear) {
  const double x = std::clamp(double(linear), 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

}  // namespace

std::vector<std::string> lesson_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".cpp" && std::isdigit(static_cast<unsigned char>(name[0])))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file.string(), "cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string marked_code(const std::string& name, const std::string& source) {
  std::string code;
  std::vector<std::string> piece;
  bool inside = false;
  for (const std::string& line : lines_of(source)) {
    const std::string words = line.substr(indent_of(line));
    if (words == idea_begins || words == idea_ends) {
      if (inside == (words == idea_begins))
        throw Error(name, "'" + words + "' stands where it does not belong");
      inside = !inside;
      if (!inside) code += (code.empty() ? "" : "\n") + moved_left(piece);
      piece.clear();
    } else if (inside) {
      piece.push_back(line);
    }
  }
  if (inside) throw Error(name, "'// end of new idea' is missing");
  if (code.empty()) throw Error(name, "'// new idea' is missing");
  return code;
}

LessonRun run_lesson(const fs::path& program, const fs::path& folder, const std::string& options) {
  fs::create_directories(folder);
  const std::string stem = (folder / program.filename()).string();
  const std::string exr = stem + ".exr", out = stem + ".out", err = stem + ".err";
  fs::remove(exr);
  const int status = std::system(("'" + program.string() + "' -o '" + exr + "' " + options + " >'" +
                                  out + "' 2>'" + err + "' </dev/null")
                                     .c_str());
  LessonRun run{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err), {}};
  if (fs::exists(exr)) run.picture = read_image(exr);
  return run;
}

std::string lasting_figures(const std::string& printed) {
  std::string text;
  std::vector<std::string> lines = lines_of(printed);
  if (!lines.empty()) lines.pop_back();  // where the picture is
  for (const std::string& line : lines)
    if (!line.ends_with(" ms")) text += line + '\n';
  return text;
}

std::string remade(const std::string& page, const std::string& text, const PageParts& parts) {
  const std::vector<std::pair<std::string, const std::string&>> all = {
      {"code", parts.code}, {"prints", parts.prints}, {"way", parts.way}};
  const std::string begins = "<!-- made: ", ends = "<!-- end -->";
  std::string result = text;
  std::size_t made = 0;
  for (std::size_t at = 0; (at = result.find(begins, at)) != std::string::npos; ++made) {
    const std::size_t name = at + begins.size(), after = result.find(" -->\n", name);
    const std::string part = result.substr(name, after - name);
    const auto found =
        std::ranges::find_if(all, [&](const auto& known) { return known.first == part; });
    if (found == all.end()) throw Error(page, "there is no part '" + part + "' to be made");
    const std::size_t end = result.find(ends, after);
    if (end == std::string::npos) throw Error(page, "part '" + part + "' has no " + ends);
    result.replace(after + 5, end - after - 5, found->second);
    at = after;
  }
  if (made != all.size()) throw Error(page, "the parts code, prints and way stand there once each");
  return result;
}

PageParts parts_of(const fs::path& folder, const std::vector<std::string>& names, std::size_t i) {
  const std::string file = names[i] + ".cpp";
  PageParts parts;
  parts.code = "From [" + file + "](" + file + "):\n\n```cpp\n" +
               marked_code(file, read_text(folder / file)) + "```\n";
  if (i > 0) parts.way += "Before: " + link_to(folder, names[i - 1]) + ". ";
  parts.way += "[All lessons](README.md).";
  if (i + 1 < names.size()) parts.way += " Next: " + link_to(folder, names[i + 1]) + ".";
  parts.way += '\n';
  return parts;
}

std::string page_title(const fs::path& folder, const std::string& name) {
  const std::string text = read_text(folder / (name + ".md"));
  if (!text.starts_with("# ")) throw Error(name + ".md", "the first line is no title");
  return text.substr(2, text.find('\n') - 2);
}

double differing_share(const Framebuffer& a, const Framebuffer& b, double tolerance) {
  if (a.width != b.width || a.height != b.height) return 1;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.pixel_count(); ++i)
    for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
      if (std::abs(screen_value(a.colour[c]) - screen_value(b.colour[c])) > tolerance) {
        ++differing;
        break;
      }
  return double(differing) / double(a.pixel_count());
}

}  // namespace scanlit::studio
