// (8) Resolve: visible fragments, gathered into spans that are long enough for vector code.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <unordered_map>

#include "rasterizer/barycentric.h"
#include "rasterizer/strides.h"

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

/// Gathers what is visible in a tile; calls shade(span) for every span that is full, and at the end
/// for what is left.
template <class Shade>
class Resolver {
 public:
  Resolver(const Frame& frame, const VisibilityTile& visibility, SpanCollector& collector,
           const Shade& shade)
      : frame_(frame),
        visibility_(visibility),
        collector_(collector),
        shade_(shade),
        perspective_(frame.settings.interpolation == Interpolation::perspective) {}

  /// Returns the number of pixels that are covered, in whole or in part.
  std::int64_t run() {
    const Rect& touched = visibility_.touched;
    for (int y = touched.y_begin; y < touched.y_end; ++y)
      resolve_row(y, touched, visibility_.samples == 1 ? sample_row(0, y) : whole_pixels(y));
    resolve_split_pixels();
    flush();
    return covered_pixels_;
  }

  /// Only what sees triangle `only`, in these pixels, with one sample each.
  void run(TriangleId only, const Rect& pixels) {
    for (int y = pixels.y_begin; y < pixels.y_end; ++y)
      resolve_row(y, pixels, pixels_of(only, y, pixels));
    flush();
  }

 private:
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

  /// Cuts a row into runs of one triangle.
  void resolve_row(int y, const Rect& pixels, const TriangleId* row) {
    const hn::RebindToUnsigned<Batch::Tag> ids;
    int begin = pixels.x_begin;
    for (int x = begin; x < pixels.x_end; x += Batch::lanes) {
      const auto differs = hn::Ne(hn::LoadU(ids, row + x), hn::LoadU(ids, row + x + 1));
      unsigned last = bits_of(Batch::Mask{hn::RebindMask(Batch::tag, differs)});
      if (const int left = pixels.x_end - x; left <= Batch::lanes) {
        const unsigned final = 1u << (left - 1);
        last = (last & (final - 1)) | final;
      }
      for (; last != 0; last &= last - 1) {
        const int end = x + std::countr_zero(last) + 1;
        resolve_run(begin, end, y, row[begin]);
        begin = end;
      }
    }
  }

  void resolve_run(int begin, int end, int y, TriangleId id) {
    if (id == no_triangle) return;
    covered_pixels_ += end - begin;
    if (id == mixed) {
      for (int x = begin; x < end; ++x) split_pixels_.push_back({x, y, 0});
      return;
    }
    const DrawnTriangle& drawn = *visibility_.triangles[id];
    FragmentSpan& span = span_of(drawn);
    if (!span.may_stride) return append_all(id, drawn, begin, y, end, span);
    while (begin < end) {
      const auto [stride, until] = stride_at(id, drawn, begin, y, end);
      if (stride > 1)
        append_some(id, drawn, begin, y, until - begin, stride, span);
      else
        append_all(id, drawn, begin, y, until, span);
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
    int until = column;
    while (strip.x_begin + until * strip.width < end && strip.stride[until] == stride) ++until;
    until = std::min(end, strip.x_begin + until * strip.width);
    return {until - x > 3 ? stride : 1, until};
  }

  void append_all(TriangleId id, const DrawnTriangle& drawn, int begin, int y, int end,
                  FragmentSpan& span) {
    while (begin < end) {
      const int count = std::min(end - begin, FragmentSpan::capacity - span.size);
      append(id, drawn, begin, y, count, span);
      begin += count;
    }
  }

  FragmentSpan& span_of(const DrawnTriangle& drawn) {
    if (!span_ || span_->draw->index != drawn.draw)
      span_ = &collector_.span_of(frame_.draw_of(drawn));
    return *span_;
  }

  /// `count` pixels of a row, for which the span has room.
  void append(TriangleId id, const DrawnTriangle& drawn, int x, int y, int count,
              FragmentSpan& span) {
    const std::uint32_t pixel = packed_pixel(x, y);
    if (span.with_derivatives) {
      append_exactly(drawn, x * subpixel + half_pixel, y * subpixel + half_pixel, pixel, count,
                     1.0f, span);
    } else if (SmallWeights::fits(drawn)) {
      const SmallWeights weights(drawn, perspective_, x, y);
      append(drawn, weights.clockwise(), weights, pixel, count, 1.0f, span);
    } else if (const LargeTriangle& large = large_triangle(id, drawn);
               perspective_ && large.planes.precise()) {
      append(drawn, large.clockwise, WeightPlanes::Row(large.planes, x, y), pixel, count, 1.0f,
             span);
    } else {
      append_exactly(drawn, x * subpixel + half_pixel, y * subpixel + half_pixel, pixel, count,
                     1.0f, span);
    }
  }

  void append_exactly(const DrawnTriangle& drawn, double x, double y, std::uint32_t pixel,
                      int count, float weight, FragmentSpan& span) {
    const ExactWeights weights(frame_, drawn);
    append(drawn, weights.clockwise(), ExactWeights::Row(weights, x, y, span.size, span), pixel,
           count, weight, span);
  }

  /// Only every so many pixels, and the last.
  void append_some(TriangleId id, const DrawnTriangle& drawn, int x, int y, int count, int stride,
                   FragmentSpan& span) {
    const int size = (count - 2) / stride + 2;
    const auto place = [&](bool clockwise, const auto& weights) {
      if (span.size + size > FragmentSpan::capacity) shade(span);
      const hn::RebindToUnsigned<Batch::Tag> pixels;
      const int first = span.size;
      for (int i = 0; i < size; i += Batch::lanes) {
        const Batch steps = min(Batch::iota(float(i)) * Batch(stride), Batch(count - 1));
        const auto [b1, b2] = weights.at(steps);
        b1.store(span.b1 + first + i);
        b2.store(span.b2 + first + i);
        Batch(1).store(span.weight + first + i);
        const auto columns = hn::ConvertTo(hn::RebindToSigned<Batch::Tag>(), steps.raw);
        const auto row = hn::Set(pixels, packed_pixel(x, y));
        hn::StoreU(hn::Add(row, hn::BitCast(pixels, columns)), pixels, span.pixel + first + i);
      }
      close(drawn, clockwise, size, stride, count, span);
    };
    if (SmallWeights::fits(drawn)) {
      const SmallWeights weights(drawn, perspective_, x, y);
      return place(weights.clockwise(), weights);
    }
    const LargeTriangle& large = large_triangle(id, drawn);
    if (perspective_ && large.planes.precise())
      return place(large.clockwise, WeightPlanes::Row(large.planes, x, y));
    const ExactWeights weights(frame_, drawn);
    return place(weights.clockwise(),
                 ExactWeights::Row(weights, x * subpixel + half_pixel, y * subpixel + half_pixel,
                                   span.size, span));
  }

  /// Ends the run of the fragments that were stored last.
  void close(const DrawnTriangle& drawn, bool clockwise, int size, int stride, int pixels,
             FragmentSpan& span) {
    span.runs[span.run_count++] = {.drawn = &drawn,
                                   .first = std::uint16_t(span.size),
                                   .size = std::uint16_t(size),
                                   .back_facing = clockwise != span.draw->mirrored,
                                   .stride = std::uint8_t(stride),
                                   .pixels = std::uint16_t(pixels)};
    span.size += size, span.pixels += pixels;
    if (span.size == FragmentSpan::capacity) shade(span);
  }

  void shade(FragmentSpan& span) {
    shade_(span);
    span.size = span.run_count = span.pixels = 0;
  }

  /// weights.at(i): the barycentric coordinates of fragments i, i + 1, ...
  template <class Weights>
  void append(const DrawnTriangle& drawn, bool clockwise, const Weights& weights,
              std::uint32_t pixel, int count, float weight, FragmentSpan& span) {
    const hn::RebindToUnsigned<Batch::Tag> pixels;
    const int first = span.size;
    for (int i = 0; i < count; i += Batch::lanes) {
      const auto [b1, b2] = weights.at(i);
      b1.store(span.b1 + first + i);
      b2.store(span.b2 + first + i);
      Batch(weight).store(span.weight + first + i);
      hn::StoreU(hn::Iota(pixels, pixel + std::uint32_t(i)), pixels, span.pixel + first + i);
    }
    close(drawn, clockwise, count, 1, count, span);
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
    append_exactly(drawn, centre_x + (centred ? 0 : sum_x / count),
                   centre_y + (centred ? 0 : sum_y / count), packed_pixel(x, y), 1,
                   float(count) / float(visibility_.samples), span_of(drawn));
    return true;
  }

  void flush() {
    collector_.flush(shade_);
    span_ = nullptr;
  }

  /// Large triangles come back row after row.
  struct LargeTriangle {
    TriangleId id = no_triangle;
    bool clockwise = false;
    WeightPlanes planes;
  };
  const LargeTriangle& large_triangle(TriangleId id, const DrawnTriangle& drawn) {
    LargeTriangle& kept = large_[id % large_.size()];
    if (kept.id != id) {
      const auto& v = drawn.vertices;
      kept = {id, screen_triangle(v[0], v[1], v[2]).twice_area < 0, WeightPlanes(drawn)};
    }
    return kept;
  }

  const Frame& frame_;
  const VisibilityTile& visibility_;
  SpanCollector& collector_;
  const Shade& shade_;
  bool perspective_;
  FragmentSpan* span_ = nullptr;  // the one that was filled last
  std::vector<TriangleId> row_;
  std::vector<SplitPixel> split_pixels_;
  std::array<LargeTriangle, 64> large_;
  std::unordered_map<TriangleId, StripStrides> strips_;
  std::int64_t covered_pixels_ = 0;
};

}  // namespace scanlit
