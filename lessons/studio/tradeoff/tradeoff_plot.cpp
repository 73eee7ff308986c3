#include "lessons/studio/tradeoff/tradeoff_plot.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "lessons/studio/reflect/ticks.h"
#include "lessons/studio/tradeoff/answer.h"
#include "lessons/studio/tradeoff/tradeoff_panel.h"

namespace scanlit::studio {
namespace {

constexpr const char* error_title = "error: rms, in 8-bit steps (sRGB)";
constexpr const char* time_title = "processor time of a frame, ms";

double steps_of(const Measured& p) { return std::max(p.steps(), 1e-9); }
double ms_of(const Measured& p) { return p.ms; }
double triangles_of(const Measured& p) { return double(p.triangles); }

void draw_time_over_error(Svg& svg, const AxisResult& axis, PlotPoint cell, bool curves) {
  const TradeoffPanel panel(svg, axis, cell, axis.title, steps_of,
                            std::string(error_title) + ", against " + axis.truth, ms_of,
                            time_title);
  panel.draw_front();
  panel.mark(0.5, "half a step");
  if (curves) panel.draw_curves();
  panel.draw_points();
  panel.draw_labels(!curves);
  panel.draw_legend(true);
}

/// From Phong's default along its error to where Gouraud's curve is as low.
void draw_answer(Svg& svg, const TradeoffPanel& panel, const Answer& a) {
  if (!a.gouraud) return;
  const PlotPoint from = panel.at(a.phong.triangles, a.phong.steps);
  const PlotPoint to = panel.at(a.gouraud->triangles, a.phong.steps);
  const double bottom = panel.place().top + panel.place().height;
  if (to.x > from.x + 12) svg.arrow({from.x + 11, from.y}, to, {"black", 1.8});
  svg.line({to.x, to.y}, {to.x, bottom}, {"black", 1, "3 3"});
  svg.line({from.x, from.y + 11}, {from.x, bottom}, {"black", 1, "3 3"});
  const auto times = [](double more, double less) {
    return tick_text(std::round(10 * more / less) / 10);
  };
  svg.text({to.x + 8, bottom - 28}, times(a.gouraud->triangles, a.phong.triangles) + " x triangles",
           {.size = 13, .bold = true, .halo = true});
  svg.text({to.x + 8, bottom - 10}, times(a.gouraud->ms, a.phong.ms) + " x time",
           {.size = 13, .bold = true, .halo = true});
}

void draw_error_over_triangles(Svg& svg, const AxisResult& axis, const Answer& answer,
                               PlotPoint cell) {
  std::string shape = axis.name;
  shape[0] = char(std::toupper(static_cast<unsigned char>(shape[0])));
  const TradeoffPanel panel(svg, axis, cell, shape + ": how many triangles does Gouraud need?",
                            triangles_of, "triangles", steps_of, error_title);
  panel.draw_curves();
  draw_answer(svg, panel, answer);
  panel.draw_points();
  panel.draw_labels(false);
  panel.draw_legend(false);
}

}  // namespace

std::string plot_tradeoffs(const std::vector<AxisResult>& axes) {
  int cells = 0;
  for (const AxisResult& axis : axes) cells += answer(axis) ? 2 : 1;
  const int columns = std::min(cells, 2);
  Svg svg(columns * TradeoffPanel::cell_width, (cells + 1) / 2 * TradeoffPanel::cell_height,
          "Run time over error");
  int cell = 0;
  const auto next = [&] {
    const PlotPoint place{cell % columns * TradeoffPanel::cell_width,
                          cell / columns * TradeoffPanel::cell_height};
    ++cell;
    return place;
  };
  for (const AxisResult& axis : axes) {
    const auto found = answer(axis);
    if (found) draw_error_over_triangles(svg, axis, *found, next());
    draw_time_over_error(svg, axis, next(), found.has_value());
  }
  return svg.finish();
}

}  // namespace scanlit::studio
