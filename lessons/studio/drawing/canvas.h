// Diagrams on a picture: polygons, lines, arrows and dots, which the engine itself draws, and
// words.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "rasterizer/framebuffer.h"
#include "rasterizer/image/labels.h"
#include "rasterizer/mesh.h"

namespace scanlit::studio {

/// Linear light. The colours of Okabe and Ito, 2008, "Color universal design", which the
/// colour-blind tell apart, and greys.
namespace ink {
inline const Rgb<double> orange{.791, .347, 0}, sky{.093, .456, .812}, green{0, .342, .171},
    yellow{.871, .776, .054}, blue{0, .168, .445}, vermilion{.665, .112, 0},
    purple{.604, .191, .386};
inline const Rgb<double> paper{.89, .89, .87}, grid{.60, .60, .58}, pale{.75, .75, .73},
    soft{.3, .31, .33}, black{.015, .017, .02}, slate{.03, .035, .045}, white{.92, .92, .92};
}  // namespace ink

struct WordSizes {
  int largest, smallest;  // pixels
};
/// For a picture of this height: the smallest, 1/40 of it, can be read from the back of a room.
WordSizes word_sizes(int picture_height);

/// Words with their baseline at y (pixels), as large as `largest`, or smaller where they would not
/// fit into max_width. Where they do not fit in the `smallest` size either, or would reach beyond
/// the picture, they are left out, and a warning says so.
void write_words(Framebuffer& picture, double x, double y, const std::string& words, Align align,
                 const Rgb<double>& colour, double max_width, const WordSizes& sizes);

/// Coordinates are units: x to the right, y down, the origin at the top left corner of a window of
/// units that is as large as fits into the middle of the picture. So with a window of 30 x 20 a
/// unit is a pixel under the magnifying glass: pixel (i, j) has its centre at (i + 1/2, j + 1/2).
/// Widths of lines and radii of dots are in 1/1000 of the picture's height. What is drawn later
/// lies on top, words above all.
class Canvas {
 public:
  /// On a picture, in its own pixels ...
  explicit Canvas(Framebuffer picture);
  /// ... or on paper of one colour.
  Canvas(int width, int height, glm::dvec2 window, const Rgb<double>& paper = ink::paper);

  /// Words as for a picture of this height: the sheet's, where the canvas is a panel of one.
  void letter_for(int sheet_height) { letter(word_sizes(sheet_height)); }
  void letter(const WordSizes& sizes) { word_sizes_ = sizes; }

  /// The image's pixels as unit squares, (0, 0) at the origin. It lies below all that is drawn.
  void image(const Framebuffer& image);
  void rectangle(glm::dvec2 low, glm::dvec2 high, const Rgb<double>& colour);
  void cell(int i, int j, const Rgb<double>& colour);  // the unit square at (i, j)
  void grid(int columns, int rows, const Rgb<double>& colour = ink::grid, double width = 2);
  void polygon(const std::vector<glm::dvec2>& convex, const Rgb<double>& colour);
  void line(glm::dvec2 a, glm::dvec2 b, const Rgb<double>& colour, double width = 6);
  void polyline(const std::vector<glm::dvec2>& points, const Rgb<double>& colour, double width = 6);
  void outline(std::vector<glm::dvec2> points, const Rgb<double>& colour, double width = 6);
  void arrow(glm::dvec2 from, glm::dvec2 to, const Rgb<double>& colour, double width = 6);
  void dot(glm::dvec2 centre, const Rgb<double>& colour, double radius = 8);
  void words(glm::dvec2 at, const std::string& words, const Rgb<double>& colour,
             Align align = Align::left);

  /// The picture with all that was drawn on it.
  Framebuffer finish();

 private:
  glm::dvec2 pixel(glm::dvec2 units) const { return origin_ + scale_ * units; }
  double thickness(double thousandths) const { return thousandths * picture_.height / 1000; }
  void fan(const std::vector<glm::dvec2>& pixels, const Rgb<double>& colour);
  void stroke(glm::dvec2 a, glm::dvec2 b, const Rgb<double>& colour, double width);

  struct Words {
    glm::dvec2 at;
    std::string words;
    Rgb<double> colour;
    Align align;
  };
  Framebuffer picture_;
  WordSizes word_sizes_;
  glm::dvec2 origin_{0};
  double scale_ = 1;
  Mesh shapes_;
  std::vector<Words> words_;
};

}  // namespace scanlit::studio
