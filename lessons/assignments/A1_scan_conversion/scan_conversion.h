// A1, scan conversion: what is yours to write, in scan_conversion.cpp. README.md says what each
// function is to do.
#pragma once

#include <cstdint>
#include <vector>

namespace a1 {

/// On the screen, in 1/256 pixel; |x|, |y| < 2^24. Products of two such numbers want 64 bits.
struct Point {
  std::int64_t x, y;
};

struct Triangle {
  Point corners[3];  // in any order
};

/// E(p) = a p.x + b p.y + c: positive on the triangle's side of the edge.
struct Edge {
  std::int64_t a, b, c;
  bool owned = false;  // the points on the edge are the triangle's
};

/// In pixels. Columns are 0 .. width - 1, rows 0 .. height - 1.
struct Picture {
  int width, height;
};

/// Columns begin .. end - 1 of a row; none where end <= begin.
struct Span {
  int begin, end;
};

struct Fragment {
  int column, row;
};

/// The functions below, for scan_convert() to call. While A1.5 is judged these are right, whatever
/// yours are; in the picture of A1.6 they are your own.
struct Stages {
  Edge (*edge)(Point from, Point to, Point third);
  bool (*owns)(const Edge& edge);
  bool (*covers)(const Edge (&edges)[3], int column, int row);
  Span (*span)(const Edge (&edges)[3], int row, int width);
};

/// A1.1
Edge edge(Point from, Point to, Point third);
/// A1.2
bool owns(const Edge& edge);
/// A1.3
bool covers(const Edge (&edges)[3], int column, int row);
/// A1.4
Span span(const Edge (&edges)[3], int row, int width);
/// A1.5, and with it the picture of A1.6
void scan_convert(const Triangle& triangle, const Picture& picture, const Stages& stages,
                  std::vector<Fragment>& fragments);

}  // namespace a1
