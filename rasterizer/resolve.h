// (8) Resolve: visible fragments, gathered into spans that are long enough for vector code.
#pragma once

#include <hwy/cache_control.h>

#include <algorithm>
#include <span>
#include <unordered_map>

#include "rasterizer/barycentric.h"
#include "rasterizer/batch.h"
#include "rasterizer/span_collector.h"
#include "rasterizer/strides.h"

namespace scanlit {

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
    for (int y = touched.y_begin; y < touched.y_end; ++y)
      resolve_row(y, touched, visibility_.samples == 1 ? sample_row(0, y) : whole_pixels(y));
    resolve_split_pixels();
    flush();
    return covered_pixels_;
  }

  /// Only what sees triangle `only`, in these pixels, if any, with one sample each.
  void run(TriangleId only, const Rect& pixels) {
    if (pixels.empty()) return;  // a triangle between the pixels' centres: rows would have no end
    for (int y = pixels.y_begin; y < pixels.y_end; ++y)
      resolve_row(y, pixels, pixels_of(only, y, pixels));
    flush();
  }

 private:
  using Unsigned = hn::RebindToUnsigned<Batch::Tag>;
  static constexpr Unsigned unsigneds{};
  static constexpr TriangleId mixed = no_triangle - 1;

  // A row of triangles is indexed by the pixel's column in the picture; a vector may be read from
  // any of its pixels on.

  const TriangleId* sample_row(int sample, int y) const {
    return visibility_.triangle.data() + visibility_.row(sample, y) - visibility_.rect.x_begin;
  }

  /// The one triangle that all of a pixel's samples see, or no_triangle, or `mixed`. The centre is
  /// then covered too: it lies in the samples' convex hull.
  const TriangleId* whole_pixels(int y) {
    const Rect& touched = visibility_.touched;
    TriangleId* const row = own_row();
    std::copy(sample_row(0, y) + touched.x_begin, sample_row(0, y) + touched.x_end,
              row + touched.x_begin);
    for (int s = 1; s < visibility_.samples; ++s) {
      const TriangleId* const other = sample_row(s, y);
      for (int x = touched.x_begin; x < touched.x_end; ++x)
        row[x] = row[x] == other[x] ? row[x] : mixed;
    }
    return row;
  }

  const TriangleId* pixels_of(TriangleId only, int y, const Rect& pixels) {
    const TriangleId* const all = sample_row(0, y);
    TriangleId* const row = own_row();
    for (int x = pixels.x_begin; x < pixels.x_end; ++x)
      row[x] = all[x] == only ? only : no_triangle;
    return row;
  }

  TriangleId* own_row() {
    row_.resize(std::size_t(visibility_.stride));
    return row_.data() - visibility_.rect.x_begin;
  }

  /// Cuts a row into runs of one triangle, and gathers them.
  void resolve_row(int y, const Rect& pixels, const TriangleId* row) {
    const std::span<const std::int32_t> ends = run_ends(pixels, row);
    // Memory answers while the first runs are gathered.
    for (const int end : ends)
      if (const TriangleId id = row[end - 1]; id < mixed) hwy::Prefetch(visibility_.triangles[id]);
    int begin = pixels.x_begin;
    for (const int end : ends) {
      resolve_run(begin, end, y, row[begin]);
      begin = end;
    }
  }

  /// Past the last pixel of each run.
  std::span<const std::int32_t> run_ends(const Rect& pixels, const TriangleId* row) {
    const hn::RebindToSigned<Batch::Tag> ints;
    ends_.resize(std::size_t(visibility_.stride));
    std::size_t count = 0;
    for (int x = pixels.x_begin; x < pixels.x_end; x += Batch::lanes) {
      const auto here = hn::LoadU(unsigneds, row + x), next = hn::LoadU(unsigneds, row + x + 1);
      const auto in_row = hn::FirstN(unsigneds, std::size_t(pixels.x_end - 1 - x));
      const auto last = hn::RebindMask(ints, hn::And(hn::Ne(here, next), in_row));
      hn::StoreU(hn::Compress(hn::Iota(ints, x + 1), last), ints, &ends_[count]);
      count += hn::CountTrue(ints, last);
    }
    ends_[count++] = pixels.x_end;
    return {ends_.data(), count};
  }

  // Called for each run, which may be of one pixel: its parts are inlined, but for those that few
  // runs come to.
  void resolve_run(int begin, int end, int y, TriangleId id) {
    if (id == no_triangle) return;
    covered_pixels_ += end - begin;
    if (id == mixed) {
      for (int x = begin; x < end; ++x) split_pixels_.push_back({x, y, 0});
      return;
    }
    const DrawnTriangle& drawn = *visibility_.triangles[id];
    FragmentSpan& span = span_of(drawn);
    if (span.may_stride) return append_stretches(id, drawn, begin, y, end, span);
    append_all(drawn, begin, y, end, span);
  }

  void append_all(const DrawnTriangle& drawn, int begin, int y, int end, FragmentSpan& span) {
    for (; begin < end; begin += FragmentSpan::capacity) {
      const int count = std::min(end - begin, FragmentSpan::capacity);
      append({.drawn = &drawn, .size = count, .pixels = count}, 1, span,
             [&](int i) { return hn::Iota(unsigneds, packed_pixel(begin + i, y)); });
    }
  }

  /// Where strides are taken.
  [[gnu::noinline]] void append_stretches(TriangleId id, const DrawnTriangle& drawn, int begin,
                                          int y, int end, FragmentSpan& span) {
    while (begin < end) {
      const auto [stride, until] = stride_at(id, drawn, begin, y, end);
      if (stride > 1)
        append_some(drawn, begin, y, until - begin, stride, span);
      else
        append_all(drawn, begin, y, until, span);
      begin = until;
    }
  }

  /// The stride of a run's pixels up to `until`.
  struct Stretch {
    int stride, until;
  };
  Stretch stride_at(TriangleId id, const DrawnTriangle& drawn, int x, int y, int end) {
    if (end - x <= 3) return {1, end};
    if (!is_large(drawn)) return {stride_of(frame_, drawn), end};
    StripStrides& strip = strips_[id];
    if (y >= strip.y_end) strip = strides_in(frame_, drawn, visibility_.rect, y);
    const int column = (x - strip.x_begin) / strip.width, stride = strip.stride[column];
    int until = column + 1;
    // From within a column no stride may lead into the next.
    const bool whole = (x - strip.x_begin) % strip.width == 0;
    while (whole && strip.x_begin + until * strip.width < end && strip.stride[until] == stride)
      ++until;
    until = std::min(end, strip.x_begin + until * strip.width);
    return {until - x > 3 ? stride : 1, until};
  }

  FragmentSpan& span_of(const DrawnTriangle& drawn) {
    if (drawn.draw != span_draw_) {
      span_ = &collector_.span_of(frame_.draw_of(drawn));
      span_draw_ = drawn.draw;
    }
    return *span_;
  }

  /// Only every so many pixels, and the last.
  void append_some(const DrawnTriangle& drawn, int x, int y, int count, int stride,
                   FragmentSpan& span) {
    const int size = (count - 2) / stride + 2;
    append({.drawn = &drawn, .size = size, .stride = stride, .pixels = count}, 1, span, [&](int i) {
      const auto step =
          hn::Mul(hn::Iota(unsigneds, unsigned(i)), hn::Set(unsigneds, unsigned(stride)));
      const auto column = hn::Min(step, hn::Set(unsigneds, unsigned(count - 1)));
      return hn::Add(hn::Set(unsigneds, packed_pixel(x, y)), column);
    });
  }

  struct NewRun {
    const DrawnTriangle* drawn;
    int size, stride = 1, pixels;
  };
  /// pixel(i) is a vector of the run's packed pixels, from its fragment i on.
  template <class Pixel>
  void append(const NewRun& run, float weight, FragmentSpan& span, const Pixel& pixel) {
    if (span.size + run.size > FragmentSpan::capacity) shade(span);
    const hn::RebindToSigned<Batch::Tag> ints;
    const int first = span.size, r = span.run_count;
    for (int i = 0; i < run.size; i += Batch::lanes) {
      hn::StoreU(pixel(i), unsigneds, span.pixel + first + i);
      hn::StoreU(hn::Set(ints, r), ints, span.run + first + i);
      Batch(weight).store(span.weight + first + i);
    }
    for (int k = 0; k < 3; ++k) span.corners[k][r] = run.drawn->vertices[k];
    span.runs[r] = {.drawn = run.drawn,
                    .first = std::uint16_t(first),
                    .size = std::uint16_t(run.size),
                    .stride = std::uint8_t(run.stride),
                    .pixels = std::uint16_t(run.pixels)};
    span.size = first + run.size, span.run_count = r + 1, span.pixels += run.pixels;
  }

  [[gnu::noinline]] void shade(FragmentSpan& span) {
    put_barycentric(frame_, span);
    shade_(span);
    span.clear();
  }

  /// A pixel whose samples see several triangles.
  struct SplitPixel {
    int x, y;
    int sample;  // the next one to look at
  };

  /// One fragment for each triangle seen in a pixel, in the order of their first samples: first the
  /// first ones of all pixels, then the second ones, ... So a pixel's sum is the same to the bit
  /// whatever spans its fragments lie in.
  void resolve_split_pixels() {
    while (!split_pixels_.empty()) {
      std::erase_if(split_pixels_, [&](SplitPixel& pixel) { return !append_next(pixel); });
      flush();
    }
  }

  /// False: the pixel has no more fragments. They lie at the pixel's centre where the triangle
  /// covers it, else at the centroid of the samples that see it: never outside the triangle, where
  /// attributes would be extrapolated.
  bool append_next(SplitPixel& pixel) {
    const auto [x, y, from] = pixel;
    const auto seen_by = [&](int sample) { return sample_row(sample, y)[x]; };
    const auto is_new = [&](int sample) {
      for (int s = 0; s < sample; ++s)
        if (seen_by(s) == seen_by(sample)) return false;
      return seen_by(sample) != no_triangle;
    };
    int first = from;
    while (first < visibility_.samples && !is_new(first)) ++first;
    if (first == visibility_.samples) return false;
    pixel.sample = first + 1;

    const auto offsets = sample_offsets(visibility_.samples);
    int count = 0;
    double sum_x = 0, sum_y = 0;
    for (int s = first; s < visibility_.samples; ++s) {
      if (seen_by(s) != seen_by(first)) continue;
      ++count, sum_x += offsets[std::size_t(s)].x, sum_y += offsets[std::size_t(s)].y;
    }
    const DrawnTriangle& drawn = *visibility_.triangles[seen_by(first)];
    const double centre_x = x * subpixel + half_pixel, centre_y = y * subpixel + half_pixel;
    const bool centred = ExactWeights(frame_, drawn).holds(centre_x, centre_y);
    FragmentSpan& span = span_of(drawn);
    const float share = float(count) / float(visibility_.samples);
    append({.drawn = &drawn, .size = 1, .pixels = 1}, share, span,
           [&](int) { return hn::Set(unsigneds, packed_pixel(x, y)); });
    if (!centred)
      span.centroids.push_back(
          {span.run_count - 1, centre_x + sum_x / count, centre_y + sum_y / count});
    return true;
  }

  void flush() {
    collector_.flush([this](FragmentSpan& span) { shade(span); });
    span_draw_ = no_id;
  }

  const Frame& frame_;
  const VisibilityTile& visibility_;
  SpanCollector& collector_;
  const Shade& shade_;
  FragmentSpan* span_ = nullptr;  // the one that was filled last, of this draw
  std::uint32_t span_draw_ = no_id;
  std::vector<TriangleId> row_;
  std::vector<std::int32_t> ends_;  // of a row's runs
  std::vector<SplitPixel> split_pixels_;
  std::unordered_map<TriangleId, StripStrides> strips_;
  std::int64_t covered_pixels_ = 0;
};

}  // namespace scanlit
