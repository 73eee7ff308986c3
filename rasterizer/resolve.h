// (8) Resolve: visible fragments, gathered into spans that are long enough for vector code.
#pragma once

#include <memory>

#include "rasterizer/batch.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

/// The spans being filled, at most one per object. Spans are reused from tile to tile.
class SpanCollector {
 public:
  /// The open span of a draw; a new one if it has none.
  FragmentSpan& span_of(const Draw& draw);

  /// Hands every open span to use(span) and closes it.
  template <class Use>
  void flush(const Use& use) {
    for (const std::uint32_t index : open_) {
      use(*spans_[index]);
      unused_.push_back(std::move(spans_[index]));
    }
    open_.clear();
  }

 private:
  std::vector<std::unique_ptr<FragmentSpan>> spans_;  // by Draw::index; null where not open
  std::vector<std::uint32_t> open_;
  std::vector<std::unique_ptr<FragmentSpan>> unused_;
};

/// What the fragments of one visible triangle have in common.
class VisibleTriangle {
 public:
  VisibleTriangle(const Frame& frame, const DrawnTriangle& drawn);

  const Draw& draw() const { return *draw_; }

  /// Whether a point on the screen, in 1/256 pixel, lies in the triangle or on its border.
  bool holds(double x, double y) const;

  /// Appends `count` fragments to a span that has room for them: pixels from `pixel` on, at screen
  /// position (x, y) in 1/256 pixel and every 256 units to the right of it.
  void append(double x, double y, int count, std::uint32_t pixel, float weight,
              Interpolation interpolation, FragmentSpan& span) const;

 private:
  /// Part of append(), for models that ask for texcoord derivatives: of a vector of fragments from
  /// element `at` on, whose weights are `linear` on the screen.
  void append_derivatives(const Batch (&linear)[3], int at, bool perspective,
                          FragmentSpan& span) const;

  /// The edge functions whose share of twice_area is the screen-linear weight of corner 1 and of
  /// corner 2. Exact where x and y are whole numbers: doubles hold them (see Viewport).
  double edge_1(double x, double y) const {
    const auto& [a, b, c] = drawn_.vertices;
    return double(a.y - c.y) * (x - c.x) - double(a.x - c.x) * (y - c.y);
  }
  double edge_2(double x, double y) const {
    const auto& [a, b, c] = drawn_.vertices;
    return double(b.y - a.y) * (x - a.x) - double(b.x - a.x) * (y - a.y);
  }

  const Draw* draw_;
  const ClippedTriangle* piece_;  // null where the triangle is whole
  const DrawnTriangle& drawn_;
  double twice_area_;
  bool back_facing_;
};

/// Gathers what is visible in a tile; calls shade(span) for every span that is full, and at the end
/// for what is left.
template <class Shade>
class Resolver {
 public:
  Resolver(const Frame& frame, const VisibilityTile& visibility, SpanCollector& collector,
           const Shade& shade)
      : frame_(frame), visibility_(visibility), collector_(collector), shade_(shade) {}

  /// Returns the number of pixels that are covered, in whole or in part.
  std::int64_t run() {
    const Rect& touched = visibility_.touched;
    for (int y = touched.y_begin; y < touched.y_end; ++y) {
      if (visibility_.samples == 1)
        resolve_row(y, touched, OneSample{sample_row(0, y)});
      else
        resolve_row(y, touched, Samples{*this, y});
    }
    collector_.flush(shade_);
    return covered_pixels_;
  }

  /// Only what sees triangle `only`, in these pixels, with one sample each.
  void run(TriangleId only, const Rect& pixels) {
    for (int y = pixels.y_begin; y < pixels.y_end; ++y)
      resolve_row(y, pixels, OnlyOne{sample_row(0, y), only});
    collector_.flush(shade_);
  }

 private:
  static constexpr TriangleId mixed = no_triangle - 1;

  /// Indexed by the pixel's column in the picture.
  const TriangleId* sample_row(int sample, int y) const {
    return visibility_.triangle.data() + visibility_.row(sample, y) - visibility_.rect.x_begin;
  }

  /// What the pixels of a row see: at(x), and up to where, at most `end`, they see `id` like x.
  struct OneSample {
    const TriangleId* row;

    TriangleId at(int x) const { return row[x]; }
    int run_end(int x, int end, TriangleId id) const {
      const hn::RebindToUnsigned<Batch::Tag> tag;
      for (; x < end; x += Batch::lanes) {
        const auto same = hn::Eq(hn::LoadU(tag, row + x), hn::Set(tag, id));
        const auto other = hn::FindFirstTrue(tag, hn::Not(same));
        if (other >= 0) return std::min(x + int(other), end);
      }
      return end;
    }
  };
  struct Samples {
    const Resolver& resolver;
    int y;

    TriangleId at(int x) const { return resolver.uniform_triangle(x, y); }
    int run_end(int x, int end, TriangleId id) const {
      while (x < end && at(x) == id) ++x;
      return x;
    }
  };
  struct OnlyOne {
    const TriangleId* row;
    TriangleId only;

    TriangleId at(int x) const { return row[x] == only ? only : no_triangle; }
    int run_end(int x, int end, TriangleId id) const {
      while (x < end && at(x) == id) ++x;
      return x;
    }
  };

  /// Cuts a row into runs of one triangle.
  template <class Row>
  void resolve_row(int y, const Rect& pixels, const Row& row) {
    const int end = pixels.x_end;
    for (int x = pixels.x_begin; x < end;) {
      const TriangleId id = row.at(x);
      const int begin = x;
      x = id == mixed ? x + 1 : row.run_end(x + 1, end, id);
      if (id == no_triangle) continue;
      if (id == mixed) {
        split_pixel(begin, y);
        continue;
      }
      covered_pixels_ += x - begin;
      append(VisibleTriangle(frame_, *visibility_.triangles[id]), begin * subpixel + half_pixel,
             y * subpixel + half_pixel, x - begin, packed_pixel(begin, y), 1.0f);
    }
  }

  /// The one triangle that all of a pixel's samples see, no_triangle, or `mixed`. The centre is
  /// then covered too: it lies in the samples' convex hull.
  TriangleId uniform_triangle(int x, int y) const {
    const TriangleId first = sample_row(0, y)[x];
    for (int s = 1; s < visibility_.samples; ++s)
      if (sample_row(s, y)[x] != first) return mixed;
    return first;
  }

  /// One fragment for each triangle seen in a pixel, at the pixel's centre where the triangle
  /// covers it, else at the centroid of the samples that see it: never outside the triangle, where
  /// attributes would be extrapolated.
  void split_pixel(int x, int y) {
    ++covered_pixels_;
    const auto offsets = sample_offsets(visibility_.samples);
    const double centre_x = x * subpixel + half_pixel, centre_y = y * subpixel + half_pixel;
    for (int s = 0; s < visibility_.samples; ++s) {
      const TriangleId id = sample_row(s, y)[x];
      int first = 0;
      while (sample_row(first, y)[x] != id) ++first;
      if (first < s || id == no_triangle) continue;  // done before, or the background
      int count = 0;
      double sum_x = 0, sum_y = 0;
      for (int i = s; i < visibility_.samples; ++i) {
        if (sample_row(i, y)[x] != id) continue;
        ++count, sum_x += offsets[std::size_t(i)].x, sum_y += offsets[std::size_t(i)].y;
      }
      const VisibleTriangle triangle(frame_, *visibility_.triangles[id]);
      const bool centred = triangle.holds(centre_x, centre_y);
      append(triangle, centre_x + (centred ? 0 : sum_x / count),
             centre_y + (centred ? 0 : sum_y / count), 1, packed_pixel(x, y),
             float(count) / float(visibility_.samples));
    }
  }

  void append(const VisibleTriangle& triangle, double x, double y, int count, std::uint32_t pixel,
              float weight) {
    while (count > 0) {
      FragmentSpan& span = collector_.span_of(triangle.draw());
      const int part = std::min(count, FragmentSpan::capacity - span.size);
      triangle.append(x, y, part, pixel, weight, frame_.settings.interpolation, span);
      x += double(part) * subpixel, pixel += std::uint32_t(part), count -= part;
      if (span.size == FragmentSpan::capacity) {
        shade_(span);
        span.size = span.run_count = 0;
      }
    }
  }

  const Frame& frame_;
  const VisibilityTile& visibility_;
  SpanCollector& collector_;
  const Shade& shade_;
  std::int64_t covered_pixels_ = 0;
};

}  // namespace scanlit
