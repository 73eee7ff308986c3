#include <bit>
#include <sstream>

#include "rasterizer/error.h"
#include "rasterizer/image.h"
#include "tests/golden/golden.h"

namespace scanlit::golden {
namespace {

std::filesystem::path reference_file(const Case& golden_case,
                                     const std::filesystem::path& references) {
  return references / (golden_case.name + ".exr");
}

// The last of a float's four bytes is noise of rounding that no compression gets smaller. Without
// it values are off by at most 1 part in 65,536; coverage is a small fraction and stays exact.
void drop_last_byte(std::vector<float>& values) {
  for (float& value : values)
    value = std::bit_cast<float>((std::bit_cast<std::uint32_t>(value) + 0x80u) & ~0xffu);
}

Framebuffer compact(Framebuffer picture) {
  for (auto* plane :
       {&picture.colour, &picture.normal, &picture.ambient, &picture.diffuse, &picture.glossy})
    drop_last_byte(*plane);
  return picture;
}

std::string figures(const Difference& difference, const Framebuffer& picture) {
  std::ostringstream text;
  text << "max " << difference.max << ", mean " << difference.mean << ", RMS " << difference.rms
       << "; " << difference.pixels << " of " << picture.pixel_count()
       << " pixels beyond the tolerance";
  return text.str();
}

}  // namespace

Result check(const Case& golden_case, const std::filesystem::path& references) {
  Result result{golden_case.name, golden_case.tolerance, {}, {}, {}};
  auto& problems = result.comparison.problems;
  try {
    result.actual = golden_case.draw();
  } catch (const std::exception& error) {
    problems.push_back(std::string("drawing failed: ") + error.what());
  }
  const auto file = reference_file(golden_case, references);
  try {
    if (std::filesystem::exists(file))
      result.expected = read_image(file);
    else
      problems.push_back("there is no reference " + file.filename().string());
  } catch (const std::exception& error) {
    problems.push_back(error.what());
  }
  if (result.actual && result.expected)
    result.comparison = compare(*result.actual, *result.expected, golden_case.tolerance);
  return result;
}

std::string bless(const Case& golden_case, const std::filesystem::path& references) {
  const auto describe = [](const Result& result) {
    std::string lines;
    if (const auto& colour = result.comparison.colour) lines = figures(*colour, *result.actual);
    for (const std::string& problem : result.comparison.problems)
      lines += (lines.empty() ? "" : "\n           ") + problem;
    return lines;
  };
  Result result = check(golden_case, references);
  if (!result.actual) throw Error(golden_case.name, result.comparison.problems.front());
  // Compared with itself, a picture can only fail for what no reference may hold.
  const auto flaws = compare(*result.actual, *result.actual, golden_case.tolerance).problems;
  if (!flaws.empty()) throw Error(golden_case.name, flaws.front());

  const std::string before = describe(result);
  std::filesystem::create_directories(references);
  write_aovs(reference_file(golden_case, references), compact(*result.actual));
  result.expected = read_image(reference_file(golden_case, references));
  result.comparison = compare(*result.actual, *result.expected, golden_case.tolerance);
  return golden_case.name + "\n  before:  " + before + "\n  after:   " + describe(result) + "\n";
}

}  // namespace scanlit::golden
