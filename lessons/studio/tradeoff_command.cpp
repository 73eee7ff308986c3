// scanlit tradeoff
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "lessons/studio/progress_bar.h"
#include "lessons/studio/tradeoff/answer.h"
#include "lessons/studio/tradeoff/page.h"
#include "rasterizer/error.h"
#include "rasterizer/image/output_file.h"

namespace scanlit::studio {
namespace {

struct TradeoffOptions {
  std::string output = "tradeoff.html";
  std::optional<std::string> json;
  std::vector<std::string> axes;
};

std::vector<std::string> axis_names() {
  std::vector<std::string> names;
  for (const StudyAxis& axis : study_axes()) names.push_back(axis.name);
  return names;
}

/// Those that were asked for, or all, in their own order.
std::vector<StudyAxis> chosen_axes(const TradeoffOptions& options) {
  for (const std::string& name : options.axes)
    if (std::ranges::find(study_axes(), name, &StudyAxis::name) == study_axes().end())
      throw Error("--axis", "unknown axis '" + name + "'" + did_you_mean(name, axis_names()));
  std::vector<StudyAxis> chosen;
  for (const StudyAxis& axis : study_axes())
    if (options.axes.empty() || std::ranges::find(options.axes, axis.name) != options.axes.end())
      chosen.push_back(axis);
  return chosen;
}

/// Refused now, not after minutes.
void check_target(const std::string& option, const std::string& file, const std::string& suffix) {
  if (std::filesystem::path(file).extension() != suffix)
    throw Error(option, "'" + file + "' is not a " + suffix + " file");
  const OutputFile there_is_room(file);
}

void write(const std::string& name, const std::string& text) {
  const HoldInterrupts until_written;
  OutputFile file(name);
  std::fwrite(text.data(), 1, text.size(), file.stream());
  file.commit();
}

std::vector<AxisResult> run(const std::vector<StudyAxis>& axes) {
  ProgressBar bar("measuring");
  double total = 0, before = 0;
  for (const StudyAxis& axis : axes) total += axis.share;
  std::vector<AxisResult> results;
  for (const StudyAxis& axis : axes) {
    const auto progress = [&](double share) { bar.show((before + share * axis.share) / total); };
    results.push_back({axis.name, axis.title, axis.truth, axis.run(progress)});
    before += axis.share;
  }
  return results;
}

void write_tradeoffs(const TradeoffOptions& options) {
  const std::vector<StudyAxis> axes = chosen_axes(options);
  check_target("--output", options.output, ".html");
  if (options.json) check_target("--json", *options.json, ".json");
  const std::vector<AxisResult> results = run(axes);
  write(options.output, tradeoff_page(results));
  if (options.json) write(*options.json, tradeoff_json(results));
  std::size_t points = 0;
  for (const AxisResult& axis : results) {
    points += axis.points.size();
    if (const auto found = answer(axis)) std::cout << words(axis, *found) << '\n';
  }
  std::cout << options.output << ": " << points << " points, " << machine() << ", 1 thread\n";
}

}  // namespace

Command add_tradeoff_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("tradeoff", "Plots run time over error for many ways to draw");
  std::ostringstream footer;
  footer << "Examples:\n"
            "  scanlit tradeoff -o tradeoff.html --json tradeoff.json\n"
            "  scanlit tradeoff --axis perspective --axis arithmetic\n"
            "\n"
            "One thing is changed at a time. What can be:\n";
  for (const StudyAxis& axis : study_axes())
    footer << "  " << axis.name << std::string(14 - axis.name.size(), ' ') << axis.title << '\n';
  footer << "All take about a minute. In brackets: defaults.";
  app->footer(footer.str());
  const auto options = std::make_shared<TradeoffOptions>();
  app->add_option("-o,--output", options->output, "the page (tradeoff.html)")->type_name("FILE");
  app->add_option("--json", options->json, "all figures, as JSON")->type_name("FILE");
  app->add_option("--axis", options->axes, "what is changed; may be given several times (all)")
      ->type_name("NAME");
  return {app, [options] { write_tradeoffs(*options); }};
}

}  // namespace scanlit::studio
