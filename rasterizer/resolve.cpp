#include "rasterizer/resolve.h"

#include <algorithm>

#include "rasterizer/batch.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

FragmentSpan& SpanCollector::span_of(const Draw& draw) {
  if (spans_.size() <= draw.index) spans_.resize(draw.index + 1);
  auto& span = spans_[draw.index];
  if (!span) {
    if (unused_.empty()) unused_.push_back(std::make_unique<FragmentSpan>());
    span = std::move(unused_.back());
    unused_.pop_back();
    span->draw = &draw;
    span->size = span->run_count = 0;
    // Only at fragments is a model given pixels. Asked here, once: a run may be of one pixel.
    span->with_derivatives = draw.object->shading == Shading::phong &&
                             draw.object->material.model->needs().texcoord_derivatives;
    open_.push_back(draw.index);
  }
  return *span;
}

VisibleTriangle::VisibleTriangle(const Frame& frame, const DrawnTriangle& drawn)
    : draw_(&frame.draws[drawn.draw]),
      piece_(drawn.piece == DrawnTriangle::not_cut
                 ? nullptr
                 : &frame.chunks[drawn.chunk].pieces[drawn.piece]),
      drawn_(drawn),
      twice_area_(double(
          screen_triangle(drawn.vertices[0], drawn.vertices[1], drawn.vertices[2]).twice_area)),
      back_facing_((twice_area_ < 0) != draw_->mirrored) {}

bool VisibleTriangle::holds(double x, double y) const {
  const double sign = twice_area_ > 0 ? 1 : -1;
  const double e1 = sign * edge_1(x, y), e2 = sign * edge_2(x, y);
  return e1 >= 0 && e2 >= 0 && e1 + e2 <= sign * twice_area_;
}

namespace {

/// A triangle's weight that is linear on the screen, along a row: (start + i step) scale at pixel
/// i, in double, rounded to float once. Exact before the scale if start and step are whole numbers,
/// so that a fragment's weights do not depend on where its run begins.
struct Steps {
  double start, step, scale;

  float at(int i) const { return float((start + double(i) * step) * scale); }

  /// For i, i + 1, ...
  Batch vector_at(int i) const {
    const hn::ScalableTag<double> doubles;
    const hn::Rebind<float, decltype(doubles)> floats;
    const auto half = [&](double first) {
      const auto index = hn::Iota(doubles, first);
      const auto edge = hn::Add(hn::Set(doubles, start), hn::Mul(index, hn::Set(doubles, step)));
      return hn::DemoteTo(floats, hn::Mul(edge, hn::Set(doubles, scale)));
    };
    const int middle = i + int(hn::MaxLanes(doubles));
    return hn::Combine(Batch::tag, half(double(middle)), half(double(i)));
  }
};

/// By how much the weights of a triangle's corners grow with one step on the screen. A weight is
/// b_k = e_k / (e_0 + e_1 + e_2), e_k the edge function over w of the corner: linear on the screen.
class Growth {
 public:
  Growth(const double (&step)[3], const double (&inv_w)[3]) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      step_[k] = step[k] * inv_w[k];
      sum += step[k] * inv_w[k];
    }
    sum_ = sum;
  }

  /// db_k = (de_k - b_k d(e_0 + e_1 + e_2)) / (e_0 + e_1 + e_2): no difference of two weights, of
  /// which a pixel that is small against the triangle would leave nothing.
  void at(const Batch (&b)[3], const Batch& inverse_sum, const ClippedTriangle* piece, int i,
          FragmentSpan::Derivatives& out) const {
    Batch d[3];
    for (int k = 0; k < 3; ++k) d[k] = (step_[k] - b[k] * sum_) * inverse_sum;
    const auto in_source = [&](int vertex) {
      if (!piece) return d[vertex];
      const auto& m = piece->barycentric;
      return d[0] * Batch(m[0][vertex]) + d[1] * Batch(m[1][vertex]) + d[2] * Batch(m[2][vertex]);
    };
    in_source(1).store(out.b1 + i);
    in_source(2).store(out.b2 + i);
  }

 private:
  Batch step_[3], sum_;
};

/// From weights that are linear on the screen to those of perspective: attributes over w, and 1/w,
/// are linear on the screen; their quotient is the attribute.
template <class T>
void divide_by_w(const DrawnTriangle& triangle, T (&b)[3]) {
  const auto& [p, q, r] = triangle.vertices;
  b[0] = b[0] * T(p.inv_w), b[1] = b[1] * T(q.inv_w), b[2] = b[2] * T(r.inv_w);
  const T w = T(1) / (b[0] + b[1] + b[2]);
  b[0] = b[0] * w, b[1] = b[1] * w, b[2] = b[2] * w;
}

}  // namespace

void VisibleTriangle::append_derivatives(const Batch (&linear)[3], int at, bool perspective,
                                         FragmentSpan& span) const {
  const auto& [a, b, c] = drawn_.vertices;
  const double inv_w[3] = {perspective ? double(a.inv_w) : 1, perspective ? double(b.inv_w) : 1,
                           perspective ? double(c.inv_w) : 1};
  const double pixel = subpixel / twice_area_;
  const Growth right({(c.y - b.y) * pixel, (a.y - c.y) * pixel, (b.y - a.y) * pixel}, inv_w);
  const Growth below({(b.x - c.x) * pixel, (c.x - a.x) * pixel, (a.x - b.x) * pixel}, inv_w);
  Batch w[3];
  for (int k = 0; k < 3; ++k) w[k] = linear[k] * Batch(inv_w[k]);
  const Batch inverse_sum = Batch(1) / (w[0] + w[1] + w[2]);
  for (Batch& weight : w) weight = weight * inverse_sum;
  right.at(w, inverse_sum, piece_, at, span.dx);
  below.at(w, inverse_sum, piece_, at, span.dy);
}

void VisibleTriangle::append(double x, double y, int count, std::uint32_t pixel, float weight,
                             Interpolation interpolation, FragmentSpan& span) const {
  const auto& [a, b, c] = drawn_.vertices;
  const double area = twice_area_, scale = 1.0 / area;
  // A centroid of samples is rounded, and may lie beyond an edge by that much; 1/w would magnify
  // it.
  const auto inside = [area](double edge) { return area > 0 ? max(edge, 0.0) : min(edge, 0.0); };
  const double e1 = inside(edge_1(x, y)), step_1 = double(a.y - c.y) * subpixel;
  const double e2 = inside(edge_2(x, y)), step_2 = double(b.y - a.y) * subpixel;
  // Weight 0 from its own edge function too: as 1 - b1 - b2 in float it would lose its digits where
  // it is small, and 1/w may weigh it by a million.
  const Steps linear[3] = {
      {inside(area - e1 - e2), -step_1 - step_2, scale}, {e1, step_1, scale}, {e2, step_2, scale}};
  const bool perspective =
      interpolation == Interpolation::perspective && (a.inv_w != b.inv_w || b.inv_w != c.inv_w);

  const int first = span.size;
  if (count <= 2 && !piece_ && !span.with_derivatives) {
    // Where triangles are as small as pixels, one weight by itself: the same operations.
    for (int i = 0; i < count; ++i) {
      float w[3] = {linear[0].at(i), linear[1].at(i), linear[2].at(i)};
      if (perspective) divide_by_w(drawn_, w);
      span.b1[first + i] = w[1], span.b2[first + i] = w[2];
      span.weight[first + i] = weight;
      span.pixel[first + i] = pixel + std::uint32_t(i);
    }
  } else {
    const hn::RebindToUnsigned<Batch::Tag> unsigneds;
    for (int i = 0; i < count; i += Batch::lanes) {
      Batch w[3] = {linear[0].vector_at(i), linear[1].vector_at(i), linear[2].vector_at(i)};
      if (span.with_derivatives) append_derivatives(w, first + i, perspective, span);
      if (perspective) divide_by_w(drawn_, w);
      if (piece_) {
        const auto& m = piece_->barycentric;
        const auto in_source = [&](int vertex) {
          return w[0] * Batch(m[0][vertex]) + w[1] * Batch(m[1][vertex]) +
                 w[2] * Batch(m[2][vertex]);
        };
        const Batch source_1 = in_source(1), source_2 = in_source(2);
        w[1] = source_1, w[2] = source_2;
      }
      w[1].store(span.b1 + first + i);
      w[2].store(span.b2 + first + i);
      Batch(weight).store(span.weight + first + i);
      hn::StoreU(hn::Iota(unsigneds, pixel + std::uint32_t(i)), unsigneds, span.pixel + first + i);
    }
  }
  span.runs[span.run_count++] = {&drawn_, std::uint16_t(first), std::uint16_t(count), back_facing_};
  span.size += count;
}

}  // namespace scanlit
