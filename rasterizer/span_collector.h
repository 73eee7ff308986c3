// (8) The spans that visible fragments are gathered in.
#pragma once

#include <memory>
#include <vector>

#include "rasterizer/planes.h"

namespace scanlit {

/// The spans being filled, at most one per object. Spans are reused from tile to tile.
class SpanCollector {
 public:
  TrianglePlanes planes;  // of the triangles that spans were made of

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

}  // namespace scanlit
