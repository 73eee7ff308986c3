// scanlit check
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

#include "lessons/assignments/judge/judge.h"
#include "lessons/assignments/judge/report.h"
#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "lessons/studio/progress_bar.h"
#include "lessons/studio/tradeoff/temporary_folder.h"
#include "rasterizer/error.h"
#include "rasterizer/image/output_file.h"

namespace scanlit::studio {
namespace {

struct CheckOptions {
  std::string folder = ".", page;
};

void check(const CheckOptions& options) {
  if (!std::filesystem::is_directory(options.folder))
    throw Error(options.folder, "is not a folder");
  const std::filesystem::path folder = std::filesystem::canonical(options.folder);
  const assignments::Rubric rubric = assignments::read_rubric(folder / "rubric.toml");
  const auto& assignment = assignments::assignment(rubric.assignment);
  const std::string page = options.page.empty()
                               ? (std::filesystem::path(options.folder) / "check.html").string()
                               : options.page;
  const TemporaryFolder scratch;
  assignments::Verdict verdict;
  {
    ProgressBar bar("checking");
    verdict = assignments::judge(
        assignment, folder, rubric,
        {.scratch = scratch.file(""), .progress = [&](double share) { bar.show(share); }});
  }
  assignments::print_report(std::cout, assignment, verdict);
  const std::string text = assignments::report_page(assignment, verdict);
  const HoldInterrupts until_written;
  OutputFile file(page);
  std::fwrite(text.data(), 1, text.size(), file.stream());
  file.commit();
  std::cout << "\nThe same with pictures: " << page << '\n';
}

}  // namespace

Command add_check_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("check", "Says how far an assignment is");
  app->footer(
      "Examples:\n"
      "  scanlit check my-a1\n"
      "  scanlit check my-a1 --page /tmp/a1.html\n"
      "\n"
      "Builds the file that the assignment asks for and puts it to the tests of rubric.toml "
      "there,\n"
      "by the code that grades. Your program runs with limits of time and memory.");
  const auto options = std::make_shared<CheckOptions>();
  app->add_option("DIR", options->folder, "the assignment's folder (this one)");
  app->add_option("--page", options->page, "the page (DIR/check.html)")->type_name("FILE");
  return {app, [options] { check(*options); }};
}

}  // namespace scanlit::studio
