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

/// Rows of counts and their shares of a whole.
class CountRows {
 public:
  CountRows(std::ostream& out, const char* title, std::int64_t whole) : out_(out), whole_(whole) {
    out_ << title << '\n';
  }
  void row(const char* row_name, std::int64_t count, const char* remark = "") const {
    print_row(out_, row_name, grouped(count), percent_of(double(count), double(whole_)), remark);
  }

 private:
  std::ostream& out_;
  std::int64_t whole_;
};

void print_geometry(std::ostream& out, const FrameStats& stats, const Scene& scene) {
  const auto object_count = std::int64_t(scene.objects.size());
  const CountRows objects(out, "objects", object_count);
  objects.row("in", object_count);
  objects.row("outside the view", stats.objects_outside, "skipped");
  objects.row("hidden", stats.objects_hidden, "skipped");

  const CountRows clusters(out, "clusters of triangles", stats.clusters);
  clusters.row("in", stats.clusters, "those of objects outside the view not counted");
  clusters.row("outside the view", stats.clusters_outside, "skipped");
  clusters.row("facing away", stats.clusters_back_facing, "skipped");
  clusters.row("hidden", stats.clusters_hidden, "skipped: behind a few large triangles");
  print_row(out, "vertices", grouped(stats.vertices), "", "transformed, of the rest");

  const CountRows triangles(out, "triangles", stats.triangles);
  triangles.row("in", stats.triangles);
  triangles.row("outside the view", stats.outside, "skipped");
  triangles.row("in hidden clusters", stats.behind, "skipped");
  triangles.row("facing away", stats.back_facing, "skipped");
  triangles.row("without a pixel", stats.no_pixel, "skipped: no area, or between the samples");
  triangles.row("drawn", stats.drawn);
  triangles.row("clipped", stats.clipped, "of those drawn");
  print_row(out, "hidden", grouped(stats.hidden), "", "times skipped, behind what a tile held");
}

void print_shading(std::ostream& out, const FrameStats& stats) {
  out << "pixels\n";
  print_row(out, "tiles kept", grouped(stats.tiles_kept), "", "from the last frame");
  print_row(out, "covered", grouped(stats.covered_pixels), "", "");
  print_row(out, "fragments", grouped(stats.fragments), "",
            "shaded: once per triangle visible in a pixel");

  const CountRows evaluations(out, "evaluations of reflection models", stats.evaluations);
  evaluations.row("in", stats.evaluations, "points times lights");
  evaluations.row("in the dark", stats.evaluations_skipped, "skipped");
  const std::int64_t done = stats.evaluations - stats.evaluations_skipped;
  evaluations.row("done", done);
  print_row(out, "spans", grouped(stats.spans), "", "of points that were lit, once a light");
  if (stats.spans > 0)
    print_row(out, "mean span", fixed(double(done) / double(stats.spans), 1), "", "points");
}

}  // namespace

void print_stats(std::ostream& out, const FrameStats& stats, const Scene& scene,
                 const Skips& skips) {
  print_times(out, stats);
  print_geometry(out, stats, scene);
  print_shading(out, stats);
  for (const SkipSwitch& skip : skip_switches())
    if (!(skips.*skip.member)) out << "switched off: " << skip.name << '\n';
}

}  // namespace scanlit::studio
