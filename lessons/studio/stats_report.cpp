#include "lessons/studio/stats_report.h"

#include <cstdio>
#include <numeric>
#include <string>

#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

/// name, a figure, its share of a whole where there is one, a remark.
void print_row(std::ostream& out, const std::string& row_name, const std::string& figure,
               const std::string& percent, const std::string& remark) {
  char line[160];
  std::snprintf(line, sizeof line, "  %-20s %16s %8s  %s", row_name.c_str(), figure.c_str(),
                percent.c_str(), remark.c_str());
  std::string text = line;
  text.erase(text.find_last_not_of(' ') + 1);
  out << text << '\n';
}

std::string percent_of(double part, double whole) {
  return whole > 0 ? fixed(100 * part / whole, 1) + " %" : "";
}

void print_times(std::ostream& out, const FrameStats& stats) {
  const double total = std::accumulate(stats.seconds.begin(), stats.seconds.end(), 0.0);
  out << "time\n";
  for (std::size_t i = 0; i < stats.seconds.size(); ++i)
    print_row(out, name(static_cast<Stage>(i)), fixed(1e3 * stats.seconds[i], 2) + " ms",
              percent_of(stats.seconds[i], total), "");
  const std::string threads = std::to_string(stats.threads);
  print_row(out, "all stages", fixed(1e3 * total, 2) + " ms", "",
            "summed over " + threads + (stats.threads == 1 ? " thread" : " threads"));
  print_row(out, "by the clock", fixed(1e3 * stats.wall_seconds, 2) + " ms", "", "");
}

void print_triangles(std::ostream& out, const FrameStats& stats) {
  const auto row = [&](const char* row_name, std::int64_t count, const char* remark) {
    print_row(out, row_name, grouped(count), percent_of(double(count), double(stats.triangles)),
              remark);
  };
  out << "triangles\n";
  row("in", stats.triangles, "");
  row("outside the view", stats.outside, "skipped");
  row("facing away", stats.back_facing, "skipped");
  row("without a pixel", stats.no_pixel, "skipped: no area, or between the samples");
  row("drawn", stats.drawn, "");
  row("clipped", stats.clipped, "of those drawn");
}

void print_shading(std::ostream& out, const FrameStats& stats) {
  out << "shading\n";
  print_row(out, "vertices", grouped(stats.vertices), "", "");
  print_row(out, "covered pixels", grouped(stats.covered_pixels), "", "");
  print_row(out, "fragments", grouped(stats.fragments), "",
            "shaded: once per triangle visible in a pixel");
  print_row(out, "model evaluations", grouped(stats.evaluations), "", "points times lights");
  print_row(out, "spans", grouped(stats.spans), "", "virtual calls in which they were made");
  if (stats.spans > 0)
    print_row(out, "mean span", fixed(double(stats.evaluations) / double(stats.spans), 1), "",
              "points");
}

}  // namespace

void print_stats(std::ostream& out, const FrameStats& stats) {
  print_times(out, stats);
  print_triangles(out, stats);
  print_shading(out, stats);
}

}  // namespace scanlit::studio
