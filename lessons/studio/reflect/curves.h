// Curves of models over an angle, ready to be drawn: sampled as finely as it shows, coloured,
// named.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/studio/reflect/svg.h"
#include "models/registry.h"

namespace scanlit::studio {

struct Sample {
  double angle_deg;
  Rgb<double> value;
};

/// `f` from low_deg to high_deg, ever finer towards each of `centres_deg`, and wherever a straight
/// line between samples would be seen to differ: `drawn` says at which part of the axis' length a
/// value is drawn.
std::vector<Sample> sample(const std::function<Rgb<double>(double)>& f, double low_deg,
                           double high_deg, const std::vector<double>& centres_deg,
                           const std::function<double(double)>& drawn);

constexpr double curve_width = 2.2;

/// How a channel's own curve is drawn.
struct Channel {
  const char *name, *colour, *dash;
  double Rgb<double>::*value;
};
inline constexpr Channel channels[] = {{"red", "#D55E00", "", &Rgb<double>::r},
                                       {"green", "#009E73", "8 4", &Rgb<double>::g},
                                       {"blue", "#0072B2", "2 3", &Rgb<double>::b}};

struct Curve {
  Stroke stroke;
  std::vector<PlotPoint> points;  // angle in degrees, value
};

struct LegendEntry {
  std::string label;
  Stroke stroke;
  bool formula = false;
};

/// Curves with what tells them apart. `of_colour`: the models' channels differ, and a curve is the
/// luminance or, where there is one model and one angle, each channel has its own.
struct CurveSet {
  std::vector<Curve> curves;
  std::vector<LegendEntry> legend;
  bool of_colour = false, channels_apart = false;
  double max = 0;      // of all curves' values
  double least = 1e9;  // of those above 0
};

/// [model][light angle]; one nameless angle where there is no light.
using SampleTable = std::vector<std::vector<std::vector<Sample>>>;

CurveSet make_curves(const std::vector<models::NamedModel>& models,
                     const std::vector<double>& light_angles_deg, const SampleTable& samples);

/// Text that would be longer, with its middle left out.
std::string elided(const std::string& text, std::size_t characters);

/// A legend in as many columns as its labels leave room for in `width`; light angles, which are
/// formulas, begin a row of their own.
double legend_height(const std::vector<LegendEntry>& legend, double width);
void draw_legend(Svg& svg, PlotPoint at, const std::vector<LegendEntry>& legend, double width);

}  // namespace scanlit::studio
