#include "rasterizer/span_filling.h"

#include <array>

#include "rasterizer/compress.h"

namespace scanlit {

namespace {

using Unsigned = hn::RebindToUnsigned<Batch::Tag>;
constexpr Unsigned unsigneds;
constexpr hn::RebindToSigned<Batch::Tag> ints;

/// Of the lanes of each byte of a mask: how many before them are in it.
constexpr auto counts_before = [] {
  std::array<std::array<std::uint8_t, 8>, 256> counts{};
  for (std::size_t bits = 0; bits < 256; ++bits)
    for (std::size_t lane = 1; lane < 8; ++lane)
      counts[bits][lane] = std::uint8_t(counts[bits][lane - 1] + (bits >> (lane - 1) & 1));
  return counts;
}();

/// Of each lane: how many lanes before it are in the mask.
hn::Vec<Unsigned> count_before(hn::Mask<Unsigned> mask) {
  const unsigned bits = bits_of(Batch::Mask{hn::RebindMask(Batch::tag, mask)});
  if constexpr (Batch::lanes <= 8) {
    // Elsewhere than with AVX-512 there is no instruction that counts bits in lanes.
    const hn::Rebind<std::uint8_t, Unsigned> bytes;
    return hn::PromoteTo(unsigneds, hn::LoadU(bytes, counts_before[bits].data()));
  } else {
    const auto one = hn::Set(unsigneds, 1u);
    const auto before = hn::Sub(hn::Shl(one, hn::Iota(unsigneds, 0)), one);
    return hn::PopulationCount(hn::And(hn::Set(unsigneds, bits), before));
  }
}

}  // namespace

// A run may be of one pixel: vectors of pixels, instead of loops over a run's.
void append_fitting(int begin, int end, int y, const TriangleId* row, FragmentSpan& span) {
  int size = span.size, runs = span.run_count;
  for (int x = begin; x < end; x += Batch::lanes) {
    const auto id = hn::LoadU(unsigneds, row + x), next = hn::LoadU(unsigneds, row + x + 1);
    const auto there = hn::FirstN(unsigneds, std::size_t(end - x));
    const auto covered = hn::And(there, hn::Ne(id, hn::Set(unsigneds, no_triangle)));
    const auto not_at_end = hn::FirstN(unsigneds, std::size_t(end - 1 - x));
    const auto last = hn::AndNot(hn::And(not_at_end, hn::Eq(id, next)), covered);  // of a run
    const auto fragment = hn::Add(count_before(covered), hn::Set(unsigneds, unsigned(size)));
    const auto run = hn::Add(count_before(last), hn::Set(unsigneds, unsigned(runs)));
    const auto pixel = hn::Iota(unsigneds, packed_pixel(x, y));
    hn::StoreU(compressed(pixel, covered), unsigneds, span.pixel + size);
    hn::StoreU(hn::BitCast(ints, compressed(run, covered)), ints, span.run + size);
    Batch(1).store(span.weight + size);
    hn::StoreU(compressed(id, last), unsigneds, span.triangle + runs);
    const auto past = hn::Add(fragment, hn::Set(unsigneds, 1u));
    hn::StoreU(compressed(past, last), unsigneds, span.end + runs);
    size += int(hn::CountTrue(unsigneds, covered));
    runs += int(hn::CountTrue(unsigneds, last));
  }
  span.pixels += size - span.size;
  span.size = size, span.run_count = runs;
}

void append_run(TriangleId id, int size, float weight, FragmentSpan& span) {
  // Whole vectors: whether a light reaches the span's last one is asked of all its lanes.
  for (int i = span.size; i < span.size + size; i += Batch::lanes) {
    hn::StoreU(hn::Set(ints, span.run_count), ints, span.run + i);
    Batch(weight).store(span.weight + i);
  }
  span.size += size;
  span.triangle[span.run_count] = id;
  span.end[span.run_count++] = std::uint32_t(span.size);
}

void put_runs(const VisibilityTile& visibility, FragmentSpan& span) {
  int first = 0;
  const DrawnTriangle* const* const triangles = visibility.triangles.data();
  for (int r = 0, count = span.run_count; r < count; ++r) {
    const auto size = std::uint16_t(int(span.end[r]) - first);
    span.runs[r] = {triangles[span.triangle[r]], std::uint16_t(first), size, 1, size};
    span.first_pixel[r] = span.pixel[first];
    first += size;
  }
  for (const auto& [r, stride, pixels] : span.strided) {
    span.runs[r].stride = std::uint8_t(stride);
    span.runs[r].pixels = std::uint16_t(pixels);
  }
}

}  // namespace scanlit
