#include "lessons/studio/watch/scan_picture.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "lessons/studio/drawing/canvas.h"

namespace scanlit::studio {
namespace {

/// In units, which are magnified pixels: the grid, two lines of words above it, two below.
struct Layout {
  int columns, rows;
  glm::dvec2 window, grid;             // the window's size, the grid's top left corner
  double line;                         // from one line of words to the next
  static constexpr double left = 0.5;  // where words begin

  explicit Layout(const Rect& part)
      : columns(part.x_end - part.x_begin), rows(part.y_end - part.y_begin) {
    const double height = rows / 0.74;  // words are 1/27 of it high
    line = height / 18;
    window = {std::max(columns + 1.0, 1.35 * height), height};
    grid = {(window.x - columns) / 2, 2.3 * line};
  }
};

// Marks are black and white, words nearly: with few pixels each, they are the only ones that the
// choice of a GIF's colours never leaves out.
const Rgb<double> dark{0.08, 0.08, 0.09};

const Rgb<double>& colour_of(int triangle) {
  static const Rgb<double> colours[] = {ink::sky, ink::orange, ink::yellow, ink::green,
                                        ink::purple};
  return colours[std::size_t(triangle) % std::size(colours)];
}

std::string plural(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

class ScanPicture {
 public:
  ScanPicture(const ScanStory& story, const Moment& moment, const ScanPictureSize& size)
      : story_(story),
        moment_(moment),
        layout_(story.part),
        canvas_(size.width, size.height, layout_.window) {}

  Framebuffer draw();

 private:
  bool shaded() const { return moment_.triangle == story_.triangles.size() && moment_.row == 1; }

  // A position of the picture, in pixels, on the canvas.
  glm::dvec2 at(double x, double y) const {
    return layout_.grid + glm::dvec2(x - story_.part.x_begin, y - story_.part.y_begin);
  }
  glm::dvec2 centre(int x, int y) const { return at(x + 0.5, y + 0.5); }
  glm::dvec2 at(const ScreenVertex& v) const {
    return at(double(v.x) / subpixel, double(v.y) / subpixel);
  }

  void cells();
  void grid();
  void edges(const ScreenTriangle& triangle, const Rgb<double>& colour, double width);
  void margins();
  void row(const ScannedTriangle& triangle, const ScannedRow& row);
  void legend();
  void headline(const std::string& first, const std::string& second);
  void last_words();
  void cross(glm::dvec2 at, double radius);
  void decided(glm::dvec2 at, bool counts);

  const ScanStory& story_;
  Moment moment_;
  Layout layout_;
  Canvas canvas_;
};

/// What the pixels hold: the colour of the triangle that is nearest so far, or the shaded picture.
void ScanPicture::cells() {
  const auto fill = [&](int x, int y, const Rgb<double>& colour) {
    canvas_.rectangle(at(x, y), at(x + 1, y + 1), colour);
  };
  const Rect& part = story_.part;
  for (int y = part.y_begin; y < part.y_end && shaded(); ++y)
    for (int x = part.x_begin; x < part.x_end; ++x) {
      const std::size_t i =
          4 * (std::size_t(y) * std::size_t(story_.picture.width) + std::size_t(x));
      const auto channel = [&](std::size_t c) {
        return std::min(1.0, double(story_.picture.colour[i + c]));
      };
      fill(x, y, {channel(0), channel(1), channel(2)});
    }
  for (std::size_t k = 0; k <= moment_.triangle && k < story_.triangles.size() && !shaded(); ++k) {
    const auto& rows = story_.triangles[k].rows;
    const std::size_t done = k < moment_.triangle ? rows.size() : std::size_t(moment_.row + 1);
    for (std::size_t r = 0; r < done; ++r)
      for (std::size_t i = 0; i < rows[r].nearer.size(); ++i)
        if (rows[r].nearer[i]) fill(rows[r].x_begin + int(i), rows[r].y, colour_of(int(k)));
  }
}

void ScanPicture::grid() {
  const Rect& part = story_.part;
  for (int x = part.x_begin; x <= part.x_end; ++x)
    canvas_.line(at(x, part.y_begin), at(x, part.y_end), ink::grid, 1.5);
  for (int y = part.y_begin; y <= part.y_end; ++y)
    canvas_.line(at(part.x_begin, y), at(part.x_end, y), ink::grid, 1.5);
  for (int y = part.y_begin; y < part.y_end && !shaded(); ++y)
    for (int x = part.x_begin; x < part.x_end; ++x) canvas_.dot(centre(x, y), ink::soft, 1.7);
}

void ScanPicture::edges(const ScreenTriangle& triangle, const Rgb<double>& colour, double width) {
  const auto& [a, b, c] = triangle.vertices;
  canvas_.outline({at(a), at(b), at(c)}, colour, width);
}

/// Hides what reaches beyond the grid.
void ScanPicture::margins() {
  const glm::dvec2 low = layout_.grid - 0.04,
                   high = layout_.grid + glm::dvec2(layout_.columns, layout_.rows) + 0.04;
  const double far = 2 * (layout_.window.x + layout_.window.y);  // the canvas may be wider
  canvas_.rectangle({-far, -far}, {far, low.y}, ink::paper);
  canvas_.rectangle({-far, high.y}, {far, far}, ink::paper);
  canvas_.rectangle({-far, -far}, {low.x, far}, ink::paper);
  canvas_.rectangle({high.x, -far}, {far, far}, ink::paper);
}

void ScanPicture::cross(glm::dvec2 at, double radius) {
  for (const double sign : {-1.0, 1.0})
    canvas_.line(at - glm::dvec2(radius, sign * radius), at + glm::dvec2(radius, sign * radius),
                 ink::black, 4);
}

void ScanPicture::decided(glm::dvec2 at, bool counts) {
  canvas_.dot(at, ink::black, 8);
  if (!counts) canvas_.dot(at, ink::white, 5);
}

void ScanPicture::row(const ScannedTriangle& triangle, const ScannedRow& row) {
  const double y = row.y + 0.5;
  canvas_.line(at(story_.part.x_begin, y), at(story_.part.x_end, y), ink::black, 3);
  edges(triangle.screen, ink::black, 5);
  std::size_t behind = 0, counts = 0;
  for (std::size_t i = 0; i < row.nearer.size(); ++i)
    if (!row.nearer[i]) cross(centre(row.x_begin + int(i), row.y), 0.28), ++behind;
  for (const int x : {row.x_begin, row.x_end})
    if (row.x_begin < row.x_end) canvas_.line(at(x, row.y), at(x, row.y + 1), ink::black, 11);
  for (const EdgeCentre& centred : row.edge)
    decided(centre(centred.x, row.y), centred.counts), counts += centred.counts;

  const std::string name = "Triangle " + std::to_string(moment_.triangle + 1) + " of " +
                           std::to_string(story_.triangles.size()) + ", row " +
                           std::to_string(row.y) + ": ";
  std::string decision;
  if (row.edge.size() == 1)
    decision = std::string("1 centre on an edge: ") + (counts ? "counts" : "does not count");
  else if (!row.edge.empty())
    decision = std::to_string(row.edge.size()) + " centres on edges: " + std::to_string(counts) +
               (counts == 1 ? " counts" : " count");
  if (row.nearer.empty()) return headline(name + "an empty span", decision);
  const std::string tests = plural(row.nearer.size() - behind, "pixel") + " nearer" +
                            (behind ? ", " + std::to_string(behind) + " hidden" : "");
  headline(name + "columns " + std::to_string(row.x_begin) + " to " + std::to_string(row.x_end - 1),
           tests + (decision.empty() ? "" : "; " + decision));
}

void ScanPicture::headline(const std::string& first, const std::string& second) {
  canvas_.words({Layout::left, layout_.line * 0.85}, first, ink::black);
  canvas_.words({Layout::left, layout_.line * 1.85}, second, dark);
}

void ScanPicture::legend() {
  const double top = layout_.grid.y + layout_.rows, line = layout_.line, mark = 0.45 * line;
  const double columns[] = {0, 0.385 * layout_.window.x, 0.665 * layout_.window.x};
  const auto place = [&](int column, int row) {
    return glm::dvec2(mark + Layout::left + columns[column], top + line * (0.85 + row));
  };
  const auto words = [&](int column, int row, const std::string& text) {
    canvas_.words(place(column, row) + glm::dvec2(1.8 * mark, 0.6 * mark), text, ink::black);
  };
  const auto box = [&](int column, int row, const Rgb<double>& colour) {
    canvas_.rectangle(place(column, row) - mark, place(column, row) + mark, colour);
  };
  box(0, 0, colour_of(int(std::min(moment_.triangle, story_.triangles.size() - 1)))),
      words(0, 0, "nearest so far");
  cross(place(0, 1), 0.7 * mark), words(0, 1, "hidden: depth test lost");
  const glm::dvec2 right(mark, 0), down(0, mark);
  canvas_.line(place(1, 0) - right, place(1, 0) + right, ink::black, 3);
  words(1, 0, "active scanline");
  canvas_.line(place(1, 1) - down, place(1, 1) + down, ink::black, 11);
  words(1, 1, "span's end");
  decided(place(2, 0), true), words(2, 0, "on an edge: counts");
  decided(place(2, 1), false), words(2, 1, "on an edge: not");
}

void ScanPicture::last_words() {
  std::size_t tests = 0;
  std::set<std::pair<int, int>> pixels;
  for (const ScannedTriangle& triangle : story_.triangles)
    for (const ScannedRow& row : triangle.rows)
      for (int x = row.x_begin; x < row.x_end; ++x, ++tests) pixels.emplace(x, row.y);
  const std::string visible = plural(pixels.size(), "pixel");
  if (shaded())
    headline("Shaded: once for each pixel", "the reflection model is evaluated for " + visible);
  else
    headline("Visible: the nearest triangle at each pixel",
             plural(tests, "depth test") + " of " + plural(story_.triangles.size(), "triangle") +
                 ", " + visible);
}

Framebuffer ScanPicture::draw() {
  cells();
  grid();
  for (std::size_t k = 0; k < moment_.triangle && !shaded(); ++k)
    edges(story_.triangles[k].screen, ink::soft, 2);
  if (moment_.triangle == story_.triangles.size()) {
    last_words();
  } else if (moment_.row < 0) {
    const ScannedTriangle& t = story_.triangles[moment_.triangle];
    edges(t.screen, ink::black, 6);
    for (const ScreenVertex& v : t.screen.vertices) canvas_.dot(at(v), ink::black, 8);
    headline("Triangle " + std::to_string(moment_.triangle + 1) + " of " +
                 std::to_string(story_.triangles.size()) + ": its edges",
             "number " + std::to_string(t.triangle) + " of object " + std::to_string(t.object) +
                 ", corners snapped to 1/256 pixel");
  } else {
    const ScannedTriangle& t = story_.triangles[moment_.triangle];
    row(t, t.rows[std::size_t(moment_.row)]);
  }
  margins();
  if (!shaded() && (moment_.triangle > 0 || moment_.row >= 0)) legend();
  return canvas_.finish();
}

}  // namespace

ScanPictureSize scan_picture_size(const Rect& part, int cell) {
  const Layout layout(part);
  return {int(std::ceil(layout.window.x * cell)), int(std::ceil(layout.window.y * cell))};
}

Framebuffer scan_picture(const ScanStory& story, const Moment& moment, int cell) {
  return ScanPicture(story, moment, scan_picture_size(story.part, cell)).draw();
}

}  // namespace scanlit::studio
