// A drawing as SVG text: lines, curves and lettering, in pixels from the top left corner.
#pragma once

#include <string>
#include <vector>

namespace scanlit::studio {

struct PlotPoint {
  double x, y;
};

struct Stroke {
  std::string colour = "black";
  double width = 1;
  std::string dash = "";  // lengths of dashes and gaps, as in "6 4"; empty is solid
};

struct Lettering {
  double size = 14;
  std::string anchor = "start";  // start, middle or end: which part of the text is at its position
  std::string colour = "black";
  double turned_deg = 0;  // clockwise
  bool bold = false;
  bool formula = false;  // "f_r": the character after each _ is a subscript
  bool halo = false;     // white around the letters, so that they can be read across lines
};

/// What stands at a point. Shapes tell series apart where colours do not.
enum class Marker { circle, square, triangle, diamond };

class Svg {
 public:
  /// White paper; `title` is what a screen reader says of it.
  Svg(double width, double height, const std::string& title);

  void line(PlotPoint a, PlotPoint b, const Stroke& stroke);
  void arrow(PlotPoint from, PlotPoint to, const Stroke& stroke);
  void rectangle(PlotPoint low, PlotPoint high, const std::string& fill, const Stroke& stroke);
  /// Part of a circle; angles counter-clockwise from the right.
  void arc(PlotPoint centre, double radius, double from_deg, double to_deg, const Stroke& stroke);
  /// Lines through points; a new piece begins wherever a point is not finite. Has class="curve".
  void curve(const std::vector<PlotPoint>& points, const Stroke& stroke);
  /// `radius` is about that of a circle of the same area.
  void marker(PlotPoint at, Marker shape, double radius, const std::string& fill,
              const Stroke& stroke);
  void text(PlotPoint at, const std::string& text, const Lettering& lettering);

  /// What is drawn between the two stays inside the rectangle.
  void begin_clip(PlotPoint low, PlotPoint high);
  void end_clip();

  /// What is drawn between the two leads to `target` in the page, "point-3", and says `title` where
  /// the pointer rests on it.
  void begin_link(const std::string& target, const std::string& title);
  void end_link();

  std::string finish() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
  int clips_ = 0;
};

}  // namespace scanlit::studio
