// Lane i is triangle i. A tiny triangle is spread over a few pixels, so that the vectors run over
// triangles and not over pixels: position by position in all their boxes at once.
#include "rasterizer/tiny_triangles.h"

#include "rasterizer/compress.h"
#include "rasterizer/doubles.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit {

namespace {

constexpr int lanes = Batch::lanes;
using Ints = hn::RebindToSigned<Batch::Tag>;
using IntVector = hn::Vec<Ints>;
using IntMask = hn::Mask<Ints>;
constexpr Ints ints;

/// Boxes of at most 8 x 8 pixels. Edge functions are below 2^24 there.
constexpr int tiny_size = 8;

IntVector set(int value) { return hn::Set(ints, value); }
unsigned bits_of(IntMask mask) { return bits_of(Batch::Mask{hn::RebindMask(Batch::tag, mask)}); }

/// Corner i of the triangles, and the edge that leaves it.
struct Corners {
  IntVector x[3], y[3];
  Batch depth[3];

  explicit Corners(std::span<const DrawnTriangle> triangles) {
    static_assert(sizeof(DrawnTriangle) == 64 && sizeof(ScreenVertex) == 16);
    const auto* words = reinterpret_cast<const std::int32_t*>(triangles.data());
    const IntVector triangle = hn::Min(hn::Iota(ints, 0), set(int(triangles.size()) - 1));
    const IntVector first = hn::ShiftLeft<4>(triangle);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      x[i] = hn::GatherIndex(ints, words + 4 * i, first);
      y[i] = hn::GatherIndex(ints, words + 4 * i + 1, first);
      depth[i] = hn::BitCast(Batch::tag, hn::GatherIndex(ints, words + 4 * i + 2, first));
    }
  }
};

/// The pixels of the tile that may be covered.
struct Boxes {
  IntVector x, y, width, height;
  unsigned tiny = 0, other = 0;  // which are, and which are not: a bit each

  Boxes(const Corners& c, int count, const VisibilityTile& tile) {
    // As pixel_bounds: samples that are not at the centre are anywhere in their pixels.
    const IntVector up = set(tile.samples == 1 ? half_pixel - 1 : 0);
    const IntVector past = set(tile.samples == 1 ? 0 : 1);
    const auto first = [&](const IntVector(&v)[3]) {
      return hn::ShiftRight<8>(hn::Add(hn::Min(v[0], hn::Min(v[1], v[2])), up));
    };
    const auto end = [&](const IntVector(&v)[3]) {
      return hn::Add(hn::ShiftRight<8>(hn::Add(hn::Max(v[0], hn::Max(v[1], v[2])), up)), past);
    };
    const Rect& rect = tile.rect;
    x = first(c.x), y = first(c.y);
    const IntVector x_end = end(c.x), y_end = end(c.y);
    const IntVector size = hn::Max(hn::Sub(x_end, x), hn::Sub(y_end, y));
    const IntMask there = hn::FirstN(ints, std::size_t(count));
    const IntMask fits =
        hn::And(there, hn::And(hn::Lt(size, set(tiny_size + 1)), hn::Lt(set(rect.x_begin - 1), x)));
    tiny = bits_of(fits);
    other = bits_of(hn::AndNot(fits, there));
    y = hn::Max(y, set(rect.y_begin));
    width = hn::IfThenElseZero(fits, hn::Sub(hn::Min(x_end, set(rect.x_end)), x));
    height = hn::IfThenElseZero(fits, hn::Sub(hn::Min(y_end, set(rect.y_end)), y));
  }
};

/// Fragments of the triangles. Collected first: loops over a few pixels here and a few there would
/// end where the processor does not expect it.
struct Fragments {
  static constexpr int padded = max_lanes * tiny_size * tiny_size + max_lanes;
  int count = 0;
  std::int32_t lane[padded], place[padded];
  float depth[padded];

  void append(IntMask covered, IntVector places, const Batch& depths) {
    hn::StoreU(compressed(hn::Iota(ints, 0), covered), ints, lane + count);
    hn::StoreU(compressed(places, covered), ints, place + count);
    const auto floats = hn::RebindMask(Batch::tag, covered);
    hn::StoreU(compressed(depths.raw, floats), Batch::tag, depth + count);
    count += int(hn::CountTrue(ints, covered));
  }
};

class TinyTriangles {
 public:
  TinyTriangles(const Corners& corners, const Boxes& boxes) : boxes_(boxes) {
    const auto& [x, y, depth] = corners;
    const IntVector area = hn::Sub(hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])),
                                   hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])));
    const IntVector flip = hn::ShiftRight<31>(area);
    const auto oriented = [flip](IntVector v) { return hn::Sub(hn::Xor(v, flip), flip); };
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const int next = i == 2 ? 0 : i + 1;
      const IntVector dx = oriented(hn::Sub(x[next], x[i]));
      const IntVector dy = oriented(hn::Sub(y[next], y[i]));
      const IntVector to_x = hn::Sub(hn::ShiftLeft<8>(boxes.x), x[i]);
      const IntVector to_y = hn::Sub(hn::ShiftLeft<8>(boxes.y), y[i]);
      corner_[i] = hn::Sub(hn::Mul(dy, to_x), hn::Mul(dx, to_y));
      dx_[i] = dx, dy_[i] = dy;
      // A centre exactly on an edge counts for left edges (running down) and the top edge (running
      // left) alone: for the others 0 becomes -1.
      const IntMask top_left =
          hn::Or(hn::Gt(dy, hn::Zero(ints)),
                 hn::And(hn::Eq(dy, hn::Zero(ints)), hn::Lt(dx, hn::Zero(ints))));
      on_edge_[i] = hn::IfThenZeroElse(top_left, set(-1));
    }
    // As DepthPlane does it.
    depth_ = Doubles::from(depth[0]);
    to_b_ = Doubles::from(depth[1]) - depth_;
    to_c_ = Doubles::from(depth[2]) - depth_;
    inverse_area_ = Doubles(1) / Doubles::from(oriented(area));
    per_pixel_ = (linear(dy_[2], dy_[0]) * Doubles(subpixel)).rounded();
    min_ = min(depth[0], min(depth[1], depth[2]));
    max_ = max(depth[0], max(depth[1], depth[2]));
  }

  /// Of the covered pixels, whose places in the tile begin at the box's `corner` and go by rows of
  /// `stride`.
  void find_fragments(const SampleOffset& offset, IntVector corner, int stride,
                      Fragments& found) const {
    found.count = 0;
    const int columns = hn::GetLane(hn::MaxOfLanes(ints, boxes_.width));
    const int rows = hn::GetLane(hn::MaxOfLanes(ints, boxes_.height));
    IntVector row_start[3], per_column[3];
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const IntVector to_sample = hn::Sub(hn::Mul(dy_[i], set(half_pixel + offset.x)),
                                          hn::Mul(dx_[i], set(half_pixel + offset.y)));
      row_start[i] = hn::Add(hn::Add(corner_[i], to_sample), on_edge_[i]);
      per_column[i] = hn::ShiftLeft<8>(dy_[i]);
    }
    for (int row = 0; row < rows; ++row) {
      IntVector edge[3] = {row_start[0], row_start[1], row_start[2]};
      const IntMask in_rows = hn::Gt(boxes_.height, set(row));
      IntMask covered[tiny_size];
      // The first covered pixel of the row, and its edge functions.
      IntVector first_column = set(columns), first_b = edge[2], first_c = edge[0];
      for (int column = 0; column < columns; ++column) {
        // The sign bit of the three together is set where any of them is negative.
        const IntMask inside = hn::Gt(hn::Or(edge[0], hn::Or(edge[1], edge[2])), set(-1));
        const IntMask here = hn::And(inside, hn::And(in_rows, hn::Gt(boxes_.width, set(column))));
        covered[column] = here;
        const IntMask is_first = hn::And(here, hn::Gt(first_column, set(column)));
        first_column = hn::IfThenElse(is_first, set(column), first_column);
        first_b = hn::IfThenElse(is_first, edge[2], first_b);
        first_c = hn::IfThenElse(is_first, edge[0], first_c);
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) edge[i] = hn::Add(edge[i], per_column[i]);
      }
      const Batch anchor =
          (depth_ + linear(hn::Sub(first_b, on_edge_[2]), hn::Sub(first_c, on_edge_[0]))).rounded();
      for (int column = 0; column < columns; ++column) {
        const Batch steps = hn::ConvertTo(Batch::tag, hn::Sub(set(column), first_column));
        const IntVector place = hn::Add(corner, set(row * stride + column));
        found.append(covered[column], place, min(max(anchor + steps * per_pixel_, min_), max_));
      }
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) row_start[i] = hn::Sub(row_start[i], hn::ShiftLeft<8>(dx_[i]));
    }
  }

 private:
  /// By how much depth differs from corner a's, from two edge functions.
  Doubles linear(IntVector weight_b, IntVector weight_c) const {
    return (Doubles::from(weight_b) * to_b_ + Doubles::from(weight_c) * to_c_) * inverse_area_;
  }

  const Boxes& boxes_;
  IntVector corner_[3];  // edge functions at the upper left corner of the box
  IntVector dx_[3], dy_[3], on_edge_[3];
  Doubles depth_ = 0, to_b_ = 0, to_c_ = 0, inverse_area_ = 0;
  Batch per_pixel_, min_, max_;
};

}  // namespace

unsigned scan_convert_tiny(std::span<const DrawnTriangle> triangles, TriangleId first,
                           VisibilityTile& visibility) {
  const Corners corners(triangles);
  const Boxes boxes(corners, int(triangles.size()), visibility);
  if (boxes.tiny == 0) return boxes.other;
  const TinyTriangles tiny(corners, boxes);
  Fragments fragments;
  const Rect& rect = visibility.rect;
  const IntVector corner =
      hn::Add(hn::Mul(hn::Sub(boxes.y, set(rect.y_begin)), set(visibility.stride)),
              hn::Sub(boxes.x, set(rect.x_begin)));
  const auto samples = sample_offsets(visibility.samples);
  for (int sample = 0; sample < visibility.samples; ++sample) {
    const std::size_t plane = visibility.row(sample, rect.y_begin);
    float* const depths = visibility.depth.data() + plane;
    TriangleId* const ids = visibility.triangle.data() + plane;
    tiny.find_fragments(samples[std::size_t(sample)], corner, visibility.stride, fragments);
    for (int i = 0; i < fragments.count; ++i) {
      const int at = fragments.place[i];
      const TriangleId id = first + TriangleId(fragments.lane[i]), there = ids[at];
      const float z = fragments.depth[i], stored = depths[at];
      bool nearer = z > stored;
      if (z == stored && z > 0)
        nearer = drawn_before(*visibility.triangles[id], *visibility.triangles[there]);
      depths[at] = nearer ? z : stored;
      ids[at] = nearer ? id : there;
    }
  }
  return boxes.other;
}

}  // namespace scanlit
