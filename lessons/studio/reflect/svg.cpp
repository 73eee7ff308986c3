#include "lessons/studio/reflect/svg.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace scanlit::studio {
namespace {

/// To a hundredth of a pixel, without trailing zeros.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string result = text;
  result.erase(result.find_last_not_of('0') + 1);
  if (result.ends_with('.')) result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}
std::string attribute(const std::string& name, double value) {
  return attribute(name, number(value));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default:
        // A control character is not allowed in XML in any form.
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  return result;
}

std::string stroked(const Stroke& stroke) {
  std::string result = attribute("stroke", stroke.colour) + attribute("stroke-width", stroke.width);
  if (!stroke.dash.empty()) result += attribute("stroke-dasharray", stroke.dash);
  return result;
}

/// Subscripts as spans set lower and smaller: baseline-shift is not drawn by every program, and a
/// blank at the beginning of a span is not either.
std::string with_subscripts(const std::string& text, double size) {
  std::string result;
  bool lowered = false;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '_' && i + 1 < text.size()) {
      result += "<tspan" + attribute("dy", 0.25 * size) + attribute("font-size", 0.72 * size) +
                ">" + escaped(text.substr(i + 1, 1)) + "</tspan>";
      lowered = true;
      i += 2;
      continue;
    }
    const bool apart = text[i] == ' ';
    const std::size_t end = std::min(text.find('_', i + 1), text.size());
    result += "<tspan" + (lowered ? attribute("dy", -0.25 * size) : "") +
              (apart ? attribute("dx", 0.32 * size) : "") + ">" +
              escaped(text.substr(i + apart, end - i - apart)) + "</tspan>";
    lowered = false;
    i = end;
  }
  return result;
}

PlotPoint on_circle(PlotPoint centre, double radius, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return {centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)};
}

}  // namespace

Svg::Svg(double width, double height, const std::string& title) {
  body_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
          attribute("width", width) + attribute("height", height) +
          attribute("viewBox", "0 0 " + number(width) + " " + number(height)) +
          attribute("font-family", "DejaVu Sans, Verdana, Arial, sans-serif") +
          " stroke-linejoin=\"round\">\n<title>" + escaped(title) +
          "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
}

void Svg::line(PlotPoint a, PlotPoint b, const Stroke& stroke) {
  body_ += "<line" + attribute("x1", a.x) + attribute("y1", a.y) + attribute("x2", b.x) +
           attribute("y2", b.y) + stroked(stroke) + "/>\n";
}

void Svg::arrow(PlotPoint from, PlotPoint to, const Stroke& stroke) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  const double along_x = dx / length, along_y = dy / length;
  const double head = 5 * stroke.width, half = 2 * stroke.width;
  const PlotPoint neck{to.x - head * along_x, to.y - head * along_y};
  line(from, neck, stroke);
  body_ += "<polygon" +
           attribute("points",
                     number(to.x) + "," + number(to.y) + " " + number(neck.x - half * along_y) +
                         "," + number(neck.y + half * along_x) + " " +
                         number(neck.x + half * along_y) + "," + number(neck.y - half * along_x)) +
           attribute("fill", stroke.colour) + "/>\n";
}

void Svg::rectangle(PlotPoint low, PlotPoint high, const std::string& fill, const Stroke& stroke) {
  body_ += "<rect" + attribute("x", low.x) + attribute("y", low.y) +
           attribute("width", high.x - low.x) + attribute("height", high.y - low.y) +
           attribute("fill", fill) + stroked(stroke) + "/>\n";
}

void Svg::arc(PlotPoint centre, double radius, double from_deg, double to_deg,
              const Stroke& stroke) {
  const PlotPoint from = on_circle(centre, radius, from_deg),
                  to = on_circle(centre, radius, to_deg);
  const std::string r = number(radius);
  body_ += "<path" +
           attribute("d", "M" + number(from.x) + "," + number(from.y) + " A" + r + "," + r +
                              " 0 0 0 " + number(to.x) + "," + number(to.y)) +
           attribute("fill", "none") + stroked(stroke) + "/>\n";
}

void Svg::curve(const std::vector<PlotPoint>& points, const Stroke& stroke) {
  std::string path;
  bool pen_down = false;
  for (const PlotPoint& p : points) {
    const bool there = std::isfinite(p.x) && std::isfinite(p.y);
    if (there) path += (pen_down ? " L" : " M") + number(p.x) + "," + number(p.y);
    pen_down = there;
  }
  if (path.empty()) path = " M0,0";  // nothing to be seen of it: still a curve of the drawing
  body_ += "<path class=\"curve\"" + attribute("d", path.substr(1)) + attribute("fill", "none") +
           stroked(stroke) + "/>\n";
}

void Svg::marker(PlotPoint at, Marker shape, double radius, const std::string& fill,
                 const Stroke& stroke) {
  if (shape == Marker::circle) {
    body_ += "<circle" + attribute("cx", at.x) + attribute("cy", at.y) + attribute("r", radius) +
             attribute("fill", fill) + stroked(stroke) + "/>\n";
    return;
  }
  const int corners = shape == Marker::triangle ? 3 : 4;
  const double reach = radius * (corners == 3 ? 1.45 : 1.25);
  std::string points;
  for (int k = 0; k < corners; ++k) {
    const double first_deg = shape == Marker::square ? 45 : 90;
    const PlotPoint p = on_circle(at, reach, first_deg + 360.0 * k / corners);
    points += (k ? " " : "") + number(p.x) + "," + number(p.y);
  }
  body_ +=
      "<polygon" + attribute("points", points) + attribute("fill", fill) + stroked(stroke) + "/>\n";
}

void Svg::text(PlotPoint at, const std::string& text, const Lettering& lettering) {
  body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) +
           attribute("font-size", lettering.size) + attribute("text-anchor", lettering.anchor) +
           attribute("fill", lettering.colour);
  if (lettering.halo)
    body_ += attribute("stroke", "white") + attribute("stroke-width", 3) +
             attribute("paint-order", "stroke");
  if (lettering.bold) body_ += attribute("font-weight", "bold");
  if (lettering.turned_deg != 0)
    body_ += attribute("transform", "rotate(" + number(lettering.turned_deg) + " " + number(at.x) +
                                        " " + number(at.y) + ")");
  body_ += ">" + (lettering.formula ? with_subscripts(text, lettering.size) : escaped(text)) +
           "</text>\n";
}

void Svg::begin_clip(PlotPoint low, PlotPoint high) {
  const std::string name = "clip" + std::to_string(++clips_);
  body_ += "<clipPath" + attribute("id", name) + "><rect" + attribute("x", low.x) +
           attribute("y", low.y) + attribute("width", high.x - low.x) +
           attribute("height", high.y - low.y) + "/></clipPath>\n<g" +
           attribute("clip-path", "url(#" + name + ")") + ">\n";
}

void Svg::end_clip() { body_ += "</g>\n"; }

void Svg::begin_link(const std::string& target, const std::string& title) {
  body_ +=
      "<a" + attribute("href", "#" + escaped(target)) + "><title>" + escaped(title) + "</title>\n";
}

void Svg::end_link() { body_ += "</a>\n"; }

}  // namespace scanlit::studio
