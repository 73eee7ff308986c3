// lesson_pages [NAME...]: runs the lessons (all), and makes their pages' pictures, code and figures
// anew, and the contact sheet of all. lessons/pages builds it and runs it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/pages/page.h"
#include "lessons/studio/program.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"

namespace scanlit::studio {
namespace {

namespace fs = std::filesystem;

const fs::path folder = SCANLIT_SOURCE_DIR "/lessons";

/// Writes only what is seen to differ: processors round differently, and a picture is large.
void update_picture(const fs::path& file, const Framebuffer& picture) {
  constexpr double one_code = 1.5 / 255;
  if (fs::exists(file) && differing_share(read_image(file), picture, one_code) == 0) return;
  write_image(file, picture);
  std::cout << file.filename().string() << '\n';
}

void update_page(const std::vector<std::string>& names, std::size_t i) {
  const fs::path program = fs::path(SCANLIT_LESSONS) / names[i];
  if (!fs::exists(program)) {
    std::cout << names[i] << ": not built, for want of a library; its page stays\n";
    return;
  }
  const LessonRun run = run_lesson(program, fs::path(SCANLIT_LESSONS) / "pages");
  if (run.exit_code != 0 || !run.complaints.empty()) throw Error(names[i], run.complaints);
  update_picture(folder / (names[i] + ".png"), run.picture);
  PageParts parts = parts_of(folder, names, i);
  parts.prints = "```\n" + lasting_figures(run.printed) + "```\n";
  const std::string page = names[i] + ".md", before = read_text(folder / page);
  const std::string text = remade(page, before, parts);
  if (text == before) return;
  std::ofstream(folder / page, std::ios::binary) << text;
  std::cout << page << '\n';
}

void update_contact_sheet(const std::vector<std::string>& names) {
  constexpr int columns = 4, cell_width = 300, cell_height = 169, word = 16, gap = 16;
  const int rows = (int(names.size()) + columns - 1) / columns;
  const int row_height = cell_height + 3 * word;
  Framebuffer sheet =
      blank_picture(gap + columns * (cell_width + gap), gap + rows * row_height, ink::slate);
  for (int i = 0; i < int(names.size()); ++i) {
    const std::string& name = names[std::size_t(i)];
    const Framebuffer picture = read_image(folder / (name + ".png"));
    Canvas cell(cell_width, cell_height, {picture.width, picture.height}, ink::slate);
    cell.image(picture);
    const int x = gap + i % columns * (cell_width + gap), y = gap + i / columns * row_height;
    paste(cell.finish(), sheet, x, y);
    write_words(sheet, x + cell_width / 2.0, y + cell_height + 1.4 * word, page_title(folder, name),
                Align::centre, ink::white, cell_width, {word, word / 2});
  }
  update_picture(folder / "contact_sheet.png", sheet);
}

void update(std::vector<std::string> chosen) {
  const std::vector<std::string> names = lesson_names(folder);
  if (chosen.empty()) chosen = names;
  for (const std::string& name : chosen) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) throw Error("no lesson '" + name + "'" + did_you_mean(name, names));
    update_page(names, std::size_t(found - names.begin()));
  }
  update_contact_sheet(names);
}

}  // namespace
}  // namespace scanlit::studio

int main(int argc, char** argv) {
  return scanlit::studio::run_program("lesson_pages", argc, argv, [](CLI::App& app) {
    const auto names = std::make_shared<std::vector<std::string>>();
    app.description("Makes anew what is made in the lessons' pages, and their pictures");
    app.add_option("NAME", *names, "lessons (all)")->type_name("");
    return [names] { scanlit::studio::update(*names); };
  });
}
