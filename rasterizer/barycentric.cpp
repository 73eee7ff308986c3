#include "rasterizer/barycentric.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/edge_functions.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

ExactWeights::ExactWeights(const Frame& frame, const DrawnTriangle& drawn)
    : drawn_(drawn),
      piece_(drawn.piece == DrawnTriangle::not_cut
                 ? nullptr
                 : &frame.chunks[drawn.chunk].pieces[drawn.piece]),
      twice_area_(double(
          screen_triangle(drawn.vertices[0], drawn.vertices[1], drawn.vertices[2]).twice_area)) {
  const auto& [a, b, c] = drawn.vertices;
  perspective_ = frame.settings.interpolation == Interpolation::perspective &&
                 (a.inv_w != b.inv_w || b.inv_w != c.inv_w);
}

bool ExactWeights::holds(double x, double y) const {
  const double sign = twice_area_ > 0 ? 1 : -1;
  const double e1 = sign * edge_1(x, y), e2 = sign * edge_2(x, y);
  return e1 >= 0 && e2 >= 0 && e1 + e2 <= sign * twice_area_;
}

namespace {

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
void divide_by_w(const DrawnTriangle& triangle, Batch (&b)[3]) {
  const auto& [p, q, r] = triangle.vertices;
  b[0] = b[0] * p.inv_w, b[1] = b[1] * q.inv_w, b[2] = b[2] * r.inv_w;
  const Batch w = Batch(1) / (b[0] + b[1] + b[2]);
  b[0] = b[0] * w, b[1] = b[1] * w, b[2] = b[2] * w;
}

}  // namespace

Batch ExactWeights::Steps::at(const Batch& steps) const {
  const hn::ScalableTag<double> doubles;
  const hn::Rebind<float, decltype(doubles)> floats;
  const auto half = [&](auto some) {
    const auto index = hn::PromoteTo(doubles, some);
    const auto edge = hn::Add(hn::Set(doubles, start), hn::Mul(index, hn::Set(doubles, step)));
    return hn::DemoteTo(floats, hn::Mul(edge, hn::Set(doubles, scale)));
  };
  return hn::Combine(Batch::tag, half(hn::UpperHalf(floats, steps.raw)),
                     half(hn::LowerHalf(floats, steps.raw)));
}

ExactWeights::Row::Row(const ExactWeights& weights, double x, double y) : weights_(weights) {
  const auto& [a, b, c] = weights.drawn_.vertices;
  const double area = weights.twice_area_, scale = 1.0 / area;
  // A centroid of samples is rounded, and may lie beyond an edge by that much; 1/w would magnify
  // it.
  const auto inside = [area](double edge) { return area > 0 ? max(edge, 0.0) : min(edge, 0.0); };
  const double e1 = inside(weights.edge_1(x, y)), step_1 = double(a.y - c.y) * subpixel;
  const double e2 = inside(weights.edge_2(x, y)), step_2 = double(b.y - a.y) * subpixel;
  // Weight 0 from its own edge function too: as 1 - b1 - b2 in float it would lose its digits where
  // it is small, and 1/w may weigh it by a million.
  linear_[0] = {inside(area - e1 - e2), -step_1 - step_2, scale};
  linear_[1] = {e1, step_1, scale};
  linear_[2] = {e2, step_2, scale};
}

Barycentric ExactWeights::Row::at(const Batch& pixels) const {
  Batch w[3] = {linear_[0].at(pixels), linear_[1].at(pixels), linear_[2].at(pixels)};
  if (weights_.perspective_) divide_by_w(weights_.drawn_, w);
  if (!weights_.piece_) return {w[1], w[2]};
  const auto& m = weights_.piece_->barycentric;
  const auto in_source = [&](int vertex) {
    return w[0] * Batch(m[0][vertex]) + w[1] * Batch(m[1][vertex]) + w[2] * Batch(m[2][vertex]);
  };
  return {in_source(1), in_source(2)};
}

void ExactWeights::Row::store_derivatives(const Batch& pixels, int first,
                                          FragmentSpan& span) const {
  const auto& [a, b, c] = weights_.drawn_.vertices;
  const bool perspective = weights_.perspective_;
  const double inv_w[3] = {perspective ? double(a.inv_w) : 1, perspective ? double(b.inv_w) : 1,
                           perspective ? double(c.inv_w) : 1};
  const double pixel = subpixel / weights_.twice_area_;
  const Growth right({(c.y - b.y) * pixel, (a.y - c.y) * pixel, (b.y - a.y) * pixel}, inv_w);
  const Growth below({(b.x - c.x) * pixel, (c.x - a.x) * pixel, (a.x - b.x) * pixel}, inv_w);
  Batch w[3];
  for (int k = 0; k < 3; ++k) w[k] = linear_[k].at(pixels) * Batch(inv_w[k]);
  const Batch inverse_sum = Batch(1) / (w[0] + w[1] + w[2]);
  for (Batch& weight : w) weight = weight * inverse_sum;
  right.at(w, inverse_sum, weights_.piece_, first, span.dx);
  below.at(w, inverse_sum, weights_.piece_, first, span.dy);
}

namespace {

/// Run r begins at (x, y), in 1/256 pixel.
void put_exactly(const Frame& frame, int r, double x, double y, FragmentSpan& span) {
  const Run& run = span.runs[r];
  const ExactWeights weights(frame, *run.drawn);
  const ExactWeights::Row row(weights, x, y);
  const Batch first(float(span.pixel[run.first] & 0xffff));
  const int end = run.first + run.size;
  for (int i = run.first; i < end; i += Batch::lanes) {
    const Batch pixels = columns(span, i) - first;
    const auto own = Batch::iota(float(i)) < Batch(end);  // the next run has its own already
    const auto [b1, b2] = row.at(pixels);
    select(own, b1, Batch::load(span.b1 + i)).store(span.b1 + i);
    select(own, b2, Batch::load(span.b2 + i)).store(span.b2 + i);
    if (span.with_derivatives) row.store_derivatives(pixels, i, span);
  }
}

/// All in float.
void put_all(const Frame& frame, FragmentSpan& span) {
  const EdgeFunctions edges(frame, span);
  for (int i = 0; i < span.size; i += Batch::lanes) {
    const OfRuns of(span.run + i);
    const Batch column = columns(span, i);
    const Batch w0 = edges.at(of, 0, column), w1 = edges.at(of, 1, column),
                w2 = edges.at(of, 2, column);
    const Batch inverse_sum = reciprocal(w0 + w1 + w2);
    (w1 * inverse_sum).store(span.b1 + i);
    (w2 * inverse_sum).store(span.b2 + i);
  }
}

/// Whether fragments are shaded by more than what they have planes of (planes.h).
bool all_need_weights(const Frame& frame, const Draw& draw) {
  const bool by_normal_alone =
      draw.object->shading != Shading::phong || !draw.illumination.needs_position;
  return !(frame.colour_alone && by_normal_alone);
}

}  // namespace

void put_barycentric(const Frame& frame, FragmentSpan& span) {
  if (!span.draw->illumination.needs_weights) return;
  if (all_need_weights(frame, *span.draw)) put_all(frame, span);
  const auto put = [&](int r) {
    const std::uint32_t pixel = span.first_pixel[r];
    put_exactly(frame, r, double(pixel & 0xffff) * subpixel + half_pixel,
                double(pixel >> 16) * subpixel + half_pixel, span);
  };
  if (span.with_derivatives) {
    for (int r = 0; r < span.run_count; ++r) put(r);
  } else {
    for (const int r : span.exact) put(r);
  }
  for (const auto& [r, x, y] : span.centroids) {
    put_exactly(frame, r, x, y, span);
    span.exact.push_back(r);
  }
}

}  // namespace scanlit
