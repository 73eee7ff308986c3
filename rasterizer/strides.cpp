#include "rasterizer/strides.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>
#include <vector>

#include "rasterizer/light_misses.h"
#include "rasterizer/parallel.h"
#include "rasterizer/pixel_codes.h"
#include "rasterizer/span_math.h"
#include "rasterizer/tangents.h"

namespace scanlit {

namespace {

// Bounds of smaller triangles would cost more than they save: each alone, and a vector of them on
// average. What is then left to shade of each is worth four times the work from so many on, if the
// first bounds have spared anything.
constexpr double min_pixels_alone = 40, min_pixels = 250, min_pixels_kept = 300;
// If more is left of those that are tried, the others are not.
constexpr double max_kept = 0.7;
constexpr std::size_t tries = 3;  // vectors of them
// Of larger triangles, cells of tiles are bounded.
constexpr double large_pixels = 5000;
// Bounds of a cell take as long as lighting so many of its pixels.
constexpr int pixels_of_bounds = 40;
// So many of a chunk's pixels are to be in triangles that are bounded.
constexpr double min_share = 0.3;

double pixels_of(const DrawnTriangle& t) {
  return double(std::abs(area_of(t))) / (2 * subpixel * subpixel);
}

constexpr int strides[] = {2, 4, 8, 16};
constexpr Spacing spacings[] = {Spacing::of(2), Spacing::of(4), Spacing::of(8), Spacing::of(16)};

/// The strides of a vector of triangles.
Batch strides_of(const Frame& frame, const Draw& draw, const ScreenGroup& group) {
  const glm::mat4& m = draw.object->world_from_object;
  Vec3<Batch> normal[3], position[3];
  for (int k = 0; k < 3; ++k) {
    normal[k] = transform(draw.normal_from_object, group.normal[k]);
    position[k] = transform(glm::mat3(m), group.position[k]) + broadcast(m[3]);
  }
  const BoundedVector p = group.attribute(position);
  BoundedSurface surface{.n = direction(group.attribute(normal)),
                         .v = to_viewer(frame, group, p),
                         .n_v = {},
                         .position = p};
  surface.n_v = cosine(surface.n, surface.v);
  surface.framed = draw.object->material.model->needs().frame && !follows_texcoord(draw);
  if (surface.framed) {
    Vec3<Batch> along[3];
    for (int k = 0; k < 3; ++k) along[k] = brushed(draw, group.position[k]);
    surface.axes = {surface.n, direction(group.attribute(along))};
  }

  Misses misses;
  Batch stride(1);
  if (!add_lights(frame, draw, group, surface, spacings, misses)) return stride;
  for (std::size_t s = 0; s < std::size(strides); ++s)
    stride = select(within_tolerance(frame, misses, s), Batch(strides[s]), stride);
  return stride;
}

/// Bounds with so many cells a triangle.
void raise(const Frame& frame, std::span<const DrawnTriangle> triangles, int cells,
           std::uint8_t* found) {
  const std::size_t at_a_time = std::size_t(Batch::lanes / cells);
  for (std::size_t i = 0; i < triangles.size(); i += at_a_time) {
    ScreenGroup group;
    group.cells = cells;
    const std::size_t end = std::min(i + at_a_time, triangles.size());
    for (int lane = 0; lane < Batch::lanes; ++lane) {
      const std::size_t triangle = std::min(i + std::size_t(lane / cells), end - 1);
      group.put(frame, triangles[triangle], lane);
      group.put_inner_cell(lane);
    }
    Lanes result;
    strides_of(frame, frame.draw_of(triangles[i]), group).store(result.of);
    for (std::size_t t = i; t < end; ++t)
      found[t] = std::max(found[t], std::uint8_t(result.of[(t - i) * std::size_t(cells)]));
  }
}

struct Tried {
  bool large = false;            // some are
  double bounded = 0, kept = 0;  // of the others, if they are not too small; what of it is left
};

/// Of up to a vector of a chunk's triangles, which hold triangle `number`.
Tried find_strides(const Frame& frame, const Chunk& chunk, std::size_t number) {
  const std::size_t first = number / max_lanes * max_lanes;
  const std::span triangles(&chunk.triangles[first],
                            std::min(max_lanes, chunk.triangles.size() - first));
  Tried tried;
  double pixels[max_lanes], others = 0;  // of those that are not large
  std::uint8_t found[max_lanes];
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const double of_triangle = pixels_of(triangles[i]);
    const bool large = of_triangle >= large_pixels;
    tried.large |= large;
    found[i] = large ? by_cells : 1;
    others += pixels[i] = large ? 0 : of_triangle;
  }
  const auto kept = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) sum += pixels[i] / found[i];
    return sum;
  };
  const double count = double(triangles.size());
  if (others >= min_pixels * count) {
    tried.bounded = others;
    raise(frame, triangles, 1, found);
    // Four times the work, for sharper bounds.
    if (kept() >= min_pixels_kept * count && kept() < others) raise(frame, triangles, 4, found);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (pixels[i] > 0 && triangles[i].piece != DrawnTriangle::not_cut) found[i] = 1;
    tried.kept = kept();
  }
  // Threads that ask at the same time find the same.
  for (std::size_t i = 0; i < triangles.size(); ++i)
    chunk.strides[first + i].store(found[i], std::memory_order_relaxed);
  return tried;
}

/// Whether pixels of the triangle may lie in a rectangle.
bool may_meet(const DrawnTriangle& drawn, const Rect& r) {
  const auto& v = drawn.vertices;
  const bool turned = area_of(drawn) < 0;
  for (int k = 0; k < 3; ++k) {
    const auto outside = [&](int x, int y) {
      const auto e = edge_function(v[(k + 1) % 3], v[(k + 2) % 3], x * subpixel, y * subpixel);
      return turned ? e > 0 : e < 0;
    };
    if (outside(r.x_begin, r.y_begin) && outside(r.x_end, r.y_begin) &&
        outside(r.x_begin, r.y_end) && outside(r.x_end, r.y_end))
      return false;
  }
  return true;
}

/// Bounds up to a vector of rectangles, each one cell wide, and keeps what is better than what was
/// known of them; false if nothing is.
bool raise(const Frame& frame, const DrawnTriangle& drawn, std::span<const Rect> some,
           CellStrides& cells) {
  ScreenGroup group;
  group.put(frame, drawn);
  for (int lane = 0; lane < Batch::lanes; ++lane) {
    const Rect& r = some[std::min(std::size_t(lane), some.size() - 1)];
    // A line may end at the first pixel of the next cell.
    group.put_rectangle(drawn,
                        {(cells.x_begin + r.x_begin * cells.width) * subpixel,
                         (cells.y_begin + r.y_begin * cells.height) * subpixel,
                         (cells.x_begin + r.x_end * cells.width + 1) * subpixel,
                         (cells.y_begin + r.y_end * cells.height) * subpixel},
                        lane);
  }
  Lanes found;
  strides_of(frame, frame.draw_of(drawn), group).store(found.of);
  bool better = false;
  for (std::size_t i = 0; i < some.size(); ++i)
    for (int y = some[i].y_begin; y < some[i].y_end; ++y) {
      std::uint8_t& stride = cells.stride[y][some[i].x_begin];
      better |= found.of[i] > float(stride);
      stride = std::max(stride, std::uint8_t(found.of[i]));
    }
  return better;
}

/// Bounds some of a chunk's triangles, and by them decides whether the others are worth it, which
/// else are shaded at every pixel. False: none of the chunk is.
bool try_strides(const Frame& frame, Chunk& chunk) {
  chunk.strides = nullptr;
  const std::size_t count = chunk.triangles.size();
  if (count == 0 || !may_stride(frame, *chunk.draw)) return false;
  chunk.strides = std::make_unique<std::atomic<std::uint8_t>[]>(count);
  const std::size_t vectors = (count + max_lanes - 1) / max_lanes, some = std::min(vectors, tries);
  Tried all;
  for (std::size_t i = 0; i < some; ++i) {
    const Tried tried = find_strides(frame, chunk, vectors * (2 * i + 1) / (2 * some) * max_lanes);
    all.bounded += tried.bounded, all.kept += tried.kept, all.large |= tried.large;
  }
  const bool worth = all.kept < max_kept * all.bounded;
  double pixels = 0, bounded = 0;
  for (std::size_t i = 0; i < count && (worth || all.large); ++i) {
    const double of_triangle = pixels_of(chunk.triangles[i]);
    const bool large = of_triangle >= large_pixels;
    pixels += of_triangle;
    if (large || (worth && of_triangle >= min_pixels)) bounded += of_triangle;
    if (!worth) chunk.strides[i].store(large ? by_cells : 1, std::memory_order_relaxed);
  }
  // Where few are bounded, asking for them costs as much as they spare.
  if (bounded <= min_share * pixels) chunk.strides = nullptr;
  return chunk.strides != nullptr;
}

}  // namespace

bool may_be_near(const Frame& frame) {
  return frame.settings.tolerance > rounding_codes + near_codes && frame.colour_alone;
}

bool may_stride(const Frame& frame, const Draw& draw) {
  return may_be_near(frame) && draw.object->shading == Shading::phong &&
         !draw.illumination.constant && draw.object->material.ambient_share == 0;
}

CellStrides strides_in(const Frame& frame, const DrawnTriangle& drawn, const Rect& tile) {
  const auto& v = drawn.vertices;
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const Rect box = intersection(
      tile, {left / subpixel, top / subpixel, right / subpixel + 1, bottom / subpixel + 1});
  const int size = box.x_end - box.x_begin, high = CellStrides::cells_high;
  // Of whole strides: what is known of each of two cells says nothing of a line from one to the
  // other.
  const int strides_in_cell = (size - 1) / (Batch::lanes * max_stride) + 1;
  CellStrides cells{.x_begin = box.x_begin,
                    .y_begin = box.y_begin,
                    .width = strides_in_cell * max_stride,
                    .height = (box.y_end - box.y_begin - 1) / high + 1};
  for (auto& row : cells.stride) std::ranges::fill(row, std::uint8_t(1));
  if (drawn.piece != DrawnTriangle::not_cut) return cells;

  // First as many columns of cells as are a vector, then those cells whose pixels are worth it.
  const int columns = (size - 1) / cells.width + 1;
  const int tall = 4 * columns <= Batch::lanes ? 1 : 2 * columns <= Batch::lanes ? 2 : high;
  std::vector<Rect> wanted;
  for (int y = 0; y < high; y += tall)
    for (int x = 0; x < columns; ++x) wanted.push_back({x, y, x + 1, y + tall});
  raise(frame, drawn, wanted, cells);
  if (tall == 1) return cells;
  wanted.clear();
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < columns; ++x) {
      const Rect pixels{cells.x_begin + x * cells.width, cells.y_begin + y * cells.height,
                        cells.x_begin + (x + 1) * cells.width,
                        cells.y_begin + (y + 1) * cells.height};
      if (area(pixels) / (2 * cells.stride[y][x]) > pixels_of_bounds && may_meet(drawn, pixels))
        wanted.push_back({x, y, x + 1, y + 1});
    }
  for (std::size_t i = 0; i < wanted.size(); i += std::size_t(Batch::lanes)) {
    const std::size_t count = std::min(wanted.size() - i, std::size_t(Batch::lanes));
    // After a vector in vain the others are not tried.
    if (!raise(frame, drawn, {&wanted[i], count}, cells)) break;
  }
  return cells;
}

void try_all_strides(Frame& frame) {
  std::vector<std::uint8_t> worth(frame.chunks.size());
  parallel(worth.size(), [&](std::size_t i) { worth[i] = try_strides(frame, frame.chunks[i]); });
  std::vector<std::int64_t> pixels(frame.draws.size()), bounded(frame.draws.size());
  for (const Chunk& chunk : frame.chunks) {
    if (chunk.bins.empty()) continue;  // its entries are another frame's
    for (const BinEntry& entry : chunk.entries) {
      pixels[chunk.draw->index] += entry.pixels;
      bounded[chunk.draw->index] += worth[chunk.index] ? entry.pixels : 0;
    }
  }
  for (Draw& draw : frame.draws) draw.may_stride = bounded[draw.index] > pixels[draw.index] / 2;
}

int stride_of(const Frame& frame, const DrawnTriangle& drawn) {
  const Chunk& chunk = frame.chunks[drawn.chunk];
  // What others have found of it meanwhile is not asked: that would depend on the threads.
  if (!chunk.strides || pixels_of(drawn) < min_pixels_alone) return 1;
  const std::size_t number = chunk.number_of(drawn);
  const std::atomic<std::uint8_t>& known = chunk.strides[number];
  if (known.load(std::memory_order_relaxed) == 0) find_strides(frame, chunk, number);
  return known.load(std::memory_order_relaxed);
}

}  // namespace scanlit
