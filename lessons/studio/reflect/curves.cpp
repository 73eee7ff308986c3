#include "lessons/studio/reflect/curves.h"

#include <algorithm>
#include <cmath>

#include "lessons/studio/reflect/query.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

// Okabe and Ito's palette, which the colour-blind can tell apart, without its yellow, which is too
// pale for lines on white; and dashes, for print in grey.
const char* const colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                               "#E69F00", "#56B4E9", "#000000"};
const char* const dashes[] = {"", "8 4", "2 3", "10 3 2 3", "14 4", "5 2"};

Stroke stroke(std::size_t colour, std::size_t dash) {
  return {colours[colour % std::size(colours)], curve_width, dashes[dash % std::size(dashes)]};
}

/// Halves the interval between the last sample and `b` until a straight line looks the same.
void refine(const std::function<Rgb<double>(double)>& f, const std::function<double(double)>& drawn,
            std::vector<Sample>& samples, const Sample& b, int depth) {
  constexpr double tolerance = 5e-4;  // of the axis' length: a third of a pixel
  const Sample a = samples.back();
  const double middle_deg = (a.angle_deg + b.angle_deg) / 2;
  const Sample middle{middle_deg, f(middle_deg)};
  const auto off = [&](double Rgb<double>::*c) {
    return std::abs(drawn(middle.value.*c) - (drawn(a.value.*c) + drawn(b.value.*c)) / 2);
  };
  const double worst = std::max({off(&Rgb<double>::r), off(&Rgb<double>::g), off(&Rgb<double>::b)});
  if (depth > 0 && worst > tolerance) {
    refine(f, drawn, samples, middle, depth - 1);
    refine(f, drawn, samples, b, depth - 1);
  } else {
    samples.push_back(b);
  }
}

constexpr double legend_row = 24, legend_line = 42;

struct LegendLayout {
  double column_width;
  std::size_t characters;                  // that a label may have
  std::vector<std::pair<int, int>> cells;  // row and column of each entry
  int rows = 0;

  LegendLayout(const std::vector<LegendEntry>& legend, double width) {
    constexpr double character = 8.7;  // of lettering of size 14, on the wide side
    constexpr double beside = legend_line + 10 + 24;
    std::size_t longest = 1;
    for (const LegendEntry& entry : legend) longest = std::max(longest, entry.label.size());
    const double wanted = beside + character * double(longest);
    const int columns = std::clamp(int(width / wanted), 1, 4);
    column_width = std::min(wanted, width);
    characters = std::size_t((width / columns - beside) / character);
    int column = columns;
    for (std::size_t i = 0; i < legend.size(); ++i, ++column) {
      const bool another_kind = i > 0 && legend[i].formula != legend[i - 1].formula;
      if (column == columns || another_kind) ++rows, column = 0;
      cells.emplace_back(rows - 1, column);
    }
  }
};

Curve curve_of(const std::vector<Sample>& samples, const Stroke& stroke,
               const std::function<double(const Rgb<double>&)>& value) {
  Curve curve{stroke, {}};
  for (const Sample& s : samples) curve.points.push_back({s.angle_deg, value(s.value)});
  return curve;
}

bool any_colour(const SampleTable& samples) {
  for (const auto& of_model : samples)
    for (const auto& of_angle : of_model)
      for (const auto& [angle, value] : of_angle)
        if (value != Rgb<double>(value.r)) return true;
  return false;
}

void add_channels(const std::vector<Sample>& samples, CurveSet& set) {
  for (const Channel& c : channels) {
    const Stroke look{c.colour, curve_width, c.dash};
    set.curves.push_back(curve_of(samples, look, [&](auto& value) { return value.*c.value; }));
    set.legend.push_back({c.name, look});
  }
}

/// Colours tell models apart and dashes angles; where there is only one of either, both tell the
/// others apart.
void add_models(const std::vector<models::NamedModel>& models,
                const std::vector<double>& light_angles_deg, const SampleTable& samples,
                CurveSet& set) {
  const std::size_t angles = light_angles_deg.size();
  const auto look = [&](std::size_t m, std::size_t a) {
    if (models.size() == 1) return stroke(a, a);
    return stroke(m, angles > 1 ? a : m);
  };
  const auto grey = [&](const Rgb<double>& value) {
    return set.of_colour ? luminance(value) : value.r;
  };
  for (std::size_t m = 0; m < models.size(); ++m) {
    if (models.size() > 1) set.legend.push_back({models[m].specification, look(m, 0)});
    for (std::size_t a = 0; a < samples[m].size(); ++a)
      set.curves.push_back(curve_of(samples[m][a], look(m, a), grey));
  }
  if (models.size() > 1 && angles <= 1) return;
  for (std::size_t a = 0; a < angles; ++a) {
    Stroke angle_look = look(0, a);
    if (models.size() > 1) angle_look.colour = "#555555";
    set.legend.push_back({"θ_l = " + text_of(light_angles_deg[a]) + "°", angle_look, true});
  }
}

}  // namespace

std::vector<Sample> sample(const std::function<Rgb<double>(double)>& f, double low_deg,
                           double high_deg, const std::vector<double>& centres_deg,
                           const std::function<double(double)>& drawn) {
  std::vector<double> angles;
  for (double angle = low_deg; angle < high_deg; angle += 0.5) angles.push_back(angle);
  angles.push_back(high_deg);
  for (const double centre : centres_deg)
    for (double distance = 16; distance > 1e-3; distance /= 2)
      for (const double angle : {centre - distance, centre, centre + distance})
        if (angle > low_deg && angle < high_deg) angles.push_back(angle);
  std::ranges::sort(angles);
  std::vector<Sample> samples{{angles[0], f(angles[0])}};
  for (const double angle : angles)
    if (angle > samples.back().angle_deg) refine(f, drawn, samples, {angle, f(angle)}, 8);
  return samples;
}

CurveSet make_curves(const std::vector<models::NamedModel>& models,
                     const std::vector<double>& light_angles_deg, const SampleTable& samples) {
  CurveSet set;
  set.of_colour = any_colour(samples);
  set.channels_apart = set.of_colour && models.size() == 1 && light_angles_deg.size() <= 1;
  if (set.channels_apart)
    add_channels(samples[0][0], set);
  else
    add_models(models, light_angles_deg, samples, set);
  for (const Curve& curve : set.curves)
    for (const PlotPoint& p : curve.points) {
      set.max = std::max(set.max, p.y);
      if (p.y > 0) set.least = std::min(set.least, p.y);
    }
  return set;
}

std::string elided(const std::string& text, std::size_t characters) {
  if (text.size() <= characters) return text;
  const std::size_t kept = characters / 2 - 1;
  return text.substr(0, kept) + " … " + text.substr(text.size() - kept);
}

double legend_height(const std::vector<LegendEntry>& legend, double width) {
  return legend_row * LegendLayout(legend, width).rows;
}

void draw_legend(Svg& svg, PlotPoint at, const std::vector<LegendEntry>& legend, double width) {
  const LegendLayout layout(legend, width);
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const auto [row, column] = layout.cells[i];
    const double x = at.x + layout.column_width * column, y = at.y + legend_row * row;
    svg.line({x, y - 5}, {x + legend_line, y - 5}, legend[i].stroke);
    svg.text({x + legend_line + 10, y}, elided(legend[i].label, layout.characters),
             {.size = 14, .formula = legend[i].formula});
  }
}

}  // namespace scanlit::studio
