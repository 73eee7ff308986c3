#include "rasterizer/strides.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

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
// Of larger triangles, strips of tiles are bounded, which have at least so many pixels.
constexpr double large_pixels = 5000;
// So many of a chunk's pixels are to be in triangles that are bounded.
constexpr double min_share = 0.3;
constexpr int strip_rows = 16, strip_pixels = 4096;

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
  BoundedSurface surface{
      .n = direction(group.attribute(normal)), .v = to_viewer(frame, group, p), .position = p};
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
    found[i] = large ? by_strips : 1;
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

/// Of the columns of some rows, one a lane.
void find_columns(const Frame& frame, const DrawnTriangle& drawn, const Rect& rows, int width,
                  std::uint8_t* found) {
  ScreenGroup group;
  group.put(frame, drawn);
  for (int lane = 0; lane < Batch::lanes; ++lane) {
    const int x = rows.x_begin + lane * width;
    group.put_rectangle(
        drawn,
        {x * subpixel, rows.y_begin * subpixel, (x + width + 1) * subpixel, rows.y_end * subpixel},
        lane);
  }
  Lanes result;
  strides_of(frame, frame.draw_of(drawn), group).store(result.of);
  for (int lane = 0; lane < Batch::lanes; ++lane) found[lane] = std::uint8_t(result.of[lane]);
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
    if (!worth) chunk.strides[i].store(large ? by_strips : 1, std::memory_order_relaxed);
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

StripStrides strides_in(const Frame& frame, const DrawnTriangle& drawn, const Rect& tile, int y) {
  const auto& v = drawn.vertices;
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const int bottom = std::max({v[0].y, v[1].y, v[2].y});
  Rect box = intersection(tile, {left / subpixel, y, right / subpixel + 1, bottom / subpixel + 1});
  const int size = box.x_end - box.x_begin;
  // Of whole strides: what is known of each of two columns says nothing of a line from one to the
  // other. It may end at the first pixel of the next.
  const int strides_in_column = (size - 1) / (Batch::lanes * max_stride) + 1;
  StripStrides strip{.y_end = tile.y_end,
                     .x_begin = box.x_begin,
                     .width = strides_in_column * max_stride,
                     .stride = {}};
  std::ranges::fill(strip.stride, std::uint8_t(1));
  if (drawn.piece != DrawnTriangle::not_cut) return strip;
  box.y_end = std::min(box.y_end, y + std::max(strip_rows, strip_pixels / size));
  find_columns(frame, drawn, box, strip.width, strip.stride);
  // After a strip in vain the tile's others are not tried.
  if (std::ranges::any_of(strip.stride, [](int s) { return s > 1; })) strip.y_end = box.y_end;
  return strip;
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
