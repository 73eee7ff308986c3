#include "rasterizer/span_collector.h"

#include "rasterizer/strides.h"

namespace scanlit {

FragmentSpan& SpanCollector::span_of(const Draw& draw) {
  if (spans_.size() <= draw.index) spans_.resize(draw.index + 1);
  auto& span = spans_[draw.index];
  if (!span) {
    if (unused_.empty()) unused_.push_back(std::make_unique<FragmentSpan>());
    span = std::move(unused_.back());
    unused_.pop_back();
    span->draw = &draw;
    span->clear();

    // Only at fragments is a model given pixels. Asked here, once: a run may be of one pixel.
    span->with_derivatives = draw.object->shading == Shading::phong &&
                             draw.object->material.model->needs().texcoord_derivatives;
    span->may_stride = !span->with_derivatives && draw.may_stride;
    open_.push_back(draw.index);
  }
  return *span;
}

}  // namespace scanlit
