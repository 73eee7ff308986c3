// The lessons' pages, lessons/NN_name.md: what a person wrote, and between `<!-- made: PART -->`
// and
// `<!-- end -->` what is made from the lesson itself, so that page and program say the same:
//   code    what stands between `// new idea` and `// end of new idea` in the lesson's file
//   prints  the figures that the lesson prints, but for those that are times
//   way     links to the lessons before and after
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rasterizer/framebuffer.h"

namespace scanlit::studio {

/// The lessons in the folder, "01_pixels" and so on, in order.
std::vector<std::string> lesson_names(const std::filesystem::path& folder);

/// All of a file. Throws Error where it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// What is marked in a lesson's source, each piece moved to the left as far as it goes, with an
/// empty line between pieces. Throws Error, naming the lesson: no mark, or one without its end.
std::string marked_code(const std::string& name, const std::string& source);

/// What came of running a lesson.
struct LessonRun {
  int exit_code = 0;
  std::string printed, complaints;  // stdout, stderr
  Framebuffer picture;              // linear light; empty where the lesson drew none
};
/// Runs `program` with these options; its picture and words pass through files in `folder`.
LessonRun run_lesson(const std::filesystem::path& program, const std::filesystem::path& folder,
                     const std::string& options = "");

/// Of what a lesson prints, the lines that are the same each time: no times, not the last line.
std::string lasting_figures(const std::string& printed);

/// A page's text with every part made anew. Throws Error, naming the page: an unknown part, a
/// missing one, or one without its end.
struct PageParts {
  std::string code, prints, way;
};
std::string remade(const std::string& page, const std::string& text, const PageParts& parts);

/// The parts of names[i]'s page but for `prints`; the folder holds the lessons and their pages.
PageParts parts_of(const std::filesystem::path& folder, const std::vector<std::string>& names,
                   std::size_t i);

/// The page's first line without its "# ": "1. A pixel and an image".
std::string page_title(const std::filesystem::path& folder, const std::string& name);

/// The share of pixels, 0..1, of which a channel differs by more than `tolerance` as a screen shows
/// it (0..1, sRGB); 1 where the sizes differ.
double differing_share(const Framebuffer& a, const Framebuffer& b, double tolerance);

}  // namespace scanlit::studio
