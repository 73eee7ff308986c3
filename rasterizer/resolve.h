// (8) Resolve: visible fragments, gathered into spans that are long enough for vector code.
#pragma once

#include <hwy/cache_control.h>

#include <algorithm>
#include <span>

#include "rasterizer/barycentric.h"
#include "rasterizer/batch.h"
#include "rasterizer/compress.h"
#include "rasterizer/run_strides.h"
#include "rasterizer/span_collector.h"
#include "rasterizer/span_filling.h"

namespace scanlit {

/// Gathers what is visible in a tile; calls shade(span) for every span that is full, and at the end
/// for what is left.
template <class Shade>
class Resolver {
 public:
  Resolver(const Frame& frame, const VisibilityTile& visibility, SpanCollector& collector,
           const Shade& shade)
      : frame_(frame), visibility_(visibility), collector_(collector), shade_(shade) {
    collector_.planes.begin(visibility.triangles.size());
  }

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
  static constexpr hn::RebindToSigned<Batch::Tag> ints{};

  // A row of triangles is indexed by the pixel's column in the picture; a vector may be read from
  // any of its pixels on.

  const TriangleId* sample_row(int sample, int y) const {
    return visibility_.triangle.data() + visibility_.row(sample, y) - visibility_.rect.x_begin;
  }

  /// The one triangle that all of a pixel's samples see, or no_triangle; where they see several,
  /// split_pixels_ has the pixel. The centre is covered, too: it lies in the samples' convex hull.
  const TriangleId* whole_pixels(int y) {
    const Rect& touched = visibility_.touched;
    TriangleId* const row = own_row();
    const TriangleId* const first = sample_row(0, y);
    for (int x = touched.x_begin; x < touched.x_end; ++x) {
      const auto other = [&](int sample) { return sample_row(sample, y)[x] != first[x]; };
      int s = 1;
      while (s < visibility_.samples && !other(s)) ++s;
      const bool split = s < visibility_.samples;
      if (split) split_pixels_.push_back({x, y, 0});
      row[x] = split ? no_triangle : first[x];
      covered_pixels_ += split;
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

  /// Gathers a row's fragments: all at once where they are of one draw, else draw by draw.
  void resolve_row(int y, const Rect& pixels, const TriangleId* row) {
    FragmentSpan* only = nullptr;
    if (visibility_.only_draw != no_id) {
      only = &collector_.span_of(frame_.draws[visibility_.only_draw]);
      if (!only->may_stride) return append_pixels(pixels.x_begin, pixels.x_end, y, row, *only);
    }
    const std::span<const std::int32_t> ends = run_ends(pixels, row);
    // Memory answers while the first runs are gathered.
    for (const int end : ends)
      if (const TriangleId id = row[end - 1]; id != no_triangle)
        hwy::Prefetch(visibility_.triangles[id]);
    int begin = pixels.x_begin, run = begin;
    FragmentSpan* span = nullptr;  // of the runs from `begin` on
    const auto append_open = [&](int end) {
      if (span) append_pixels(begin, end, y, row, *span);
    };
    for (const int end : ends) {
      if (row[run] != no_triangle) {
        FragmentSpan& own = only ? *only : span_of(*visibility_.triangles[row[run]]);
        const bool strided = own.may_stride && strides_.may_stride(own, row[run], end - run);
        if (strided || &own != span) append_open(run), begin = run, span = &own;
        if (strided) append_stretches(run, y, end, row, own), span = nullptr;
      }
      run = end;
    }
    append_open(pixels.x_end);
  }

  /// Past the last pixel of each run.
  std::span<const std::int32_t> run_ends(const Rect& pixels, const TriangleId* row) {
    ends_.resize(std::size_t(visibility_.stride));
    std::size_t count = 0;
    for (int x = pixels.x_begin; x < pixels.x_end; x += Batch::lanes) {
      const auto here = hn::LoadU(unsigneds, row + x), next = hn::LoadU(unsigneds, row + x + 1);
      const auto in_row = hn::FirstN(unsigneds, std::size_t(pixels.x_end - 1 - x));
      const auto last = hn::RebindMask(ints, hn::And(hn::Ne(here, next), in_row));
      hn::StoreU(compressed(hn::Iota(ints, x + 1), last), ints, &ends_[count]);
      count += hn::CountTrue(ints, last);
    }
    ends_[count++] = pixels.x_end;
    return {ends_.data(), count};
  }

  /// Pixels [begin, end) of a row, of one draw or of none.
  void append_pixels(int begin, int end, int y, const TriangleId* row, FragmentSpan& span) {
    for (int until; begin < end; begin = until) {
      if (span.size == FragmentSpan::capacity) shade(span);
      until = std::min(end, begin + FragmentSpan::capacity - span.size);
      const int before = span.size;
      append_fitting(begin, until, y, row, span);
      covered_pixels_ += span.size - before;
    }
  }

  /// Where strides are taken.
  [[gnu::noinline]] void append_stretches(int begin, int y, int end, const TriangleId* row,
                                          FragmentSpan& span) {
    const TriangleId id = row[begin];
    while (begin < end) {
      auto [stride, until] = strides_.at(id, begin, y, end);
      if (stride > 1) {
        until = std::min(until, begin + (FragmentSpan::capacity - 1) * stride + 1);
        append_some(id, begin, y, until - begin, stride, span);
      } else {
        append_pixels(begin, until, y, row, span);
      }
      begin = until;
    }
  }

  FragmentSpan& span_of(const DrawnTriangle& drawn) {
    if (drawn.draw != span_draw_) {
      span_ = &collector_.span_of(frame_.draw_of(drawn));
      span_draw_ = drawn.draw;
    }
    return *span_;
  }

  /// Only every so many pixels, and the last: no more than a span holds.
  void append_some(TriangleId id, int x, int y, int count, int stride, FragmentSpan& span) {
    const int size = (count - 2) / stride + 2;
    if (span.size + size > FragmentSpan::capacity) shade(span);
    for (int i = 0; i < size; i += Batch::lanes) {
      const auto step =
          hn::Mul(hn::Iota(unsigneds, unsigned(i)), hn::Set(unsigneds, unsigned(stride)));
      const auto column = hn::Min(step, hn::Set(unsigneds, unsigned(count - 1)));
      hn::StoreU(hn::Add(hn::Set(unsigneds, packed_pixel(x, y)), column), unsigneds,
                 span.pixel + span.size + i);
    }
    span.strided.push_back({span.run_count, stride, count});
    covered_pixels_ += count, span.pixels += count;
    append_run(id, size, 1, span);
  }

  [[gnu::noinline]] void shade(FragmentSpan& span) {
    put_runs(visibility_, span);
    collector_.planes.put(frame_, visibility_, span);
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
    if (span.size == FragmentSpan::capacity) shade(span);
    hn::StoreU(hn::Set(unsigneds, packed_pixel(x, y)), unsigneds, span.pixel + span.size);
    ++span.pixels;
    append_run(seen_by(first), 1, share, span);
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
  RunStrides strides_{frame_, visibility_};
  std::int64_t covered_pixels_ = 0;
};

}  // namespace scanlit
