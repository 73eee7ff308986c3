#include "rasterizer/strides.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

#include "rasterizer/light_misses.h"
#include "rasterizer/span_math.h"

namespace scanlit {

namespace {

// Bounds of smaller triangles would cost more than they save: each alone, and a vector of them on
// average. What is then left to shade of each is worth four times the work from so many on.
constexpr std::int64_t min_pixels_alone = 40;
constexpr double min_pixels = 100, min_pixels_kept = 300;
// Of larger triangles, tiles are bounded.
constexpr std::int64_t large_pixels = 2000;

/// By how much a colour that is at least `least` may be off.
Batch allowed(const Frame& frame, const Batch& least) {
  const Batch codes = Batch((frame.settings.tolerance - rounding_codes) / 255);
  if (frame.format == ColourFormat::linear_8bit) return codes;
  // 1 over the slope of sRGB's encoding, IEC 61966-2-1: 12.92, or that of 1.055 c^(1/2.4).
  const Batch power = exp(Batch(1 - 1 / 2.4) * log(max(least, Batch(0.003f))));
  const Batch inverse_slope =
      select(least <= Batch(0.0031308f), Batch(1 / 12.92), power * Batch(2.4 / 1.055));
  return codes * inverse_slope * Batch(0.9999f);
}

/// The strides of a vector of triangles.
Batch strides_of(const Frame& frame, const Draw& draw, const ScreenGroup& group) {
  const Illumination& illumination = draw.illumination;
  const glm::mat4& m = draw.object->world_from_object;
  Vec3<Batch> normal[3], position[3];
  for (int k = 0; k < 3; ++k) {
    normal[k] = transform(draw.normal_from_object, group.normal[k]);
    position[k] = transform(glm::mat3(m), group.position[k]) + broadcast(m[3]);
  }
  const BoundedDirection n = direction(group.attribute(normal));
  const BoundedVector p = group.attribute(position);
  const BoundedDirection v = to_viewer(frame, group, p);

  Misses sum{};
  const Rgb<float>& ambient = illumination.ambient;
  sum.least[0] = ambient.r, sum.least[1] = ambient.g, sum.least[2] = ambient.b;
  for (auto& of_stride : sum.missed)
    for (Batch& channel : of_stride) channel = Batch(0);
  for (const LightSource& light : illumination.lights)
    if (!add_light(*draw.object->material.model, light, group, n, v, p, sum)) return Batch(1);

  Batch stride(1);
  for (int s = 0; s < stride_count; ++s) {
    auto within = sum.missed[s][0] <= allowed(frame, sum.least[0]);
    for (int c = 1; c < 3; ++c)
      within = within & (sum.missed[s][c] <= allowed(frame, sum.least[c]));
    stride = select(within, Batch(strides[s]), stride);
  }
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

void find_strides(const Frame& frame, std::span<const DrawnTriangle> triangles,
                  std::uint8_t* found) {
  double pixels = 0, kept = 0;
  for (const DrawnTriangle& t : triangles)
    pixels += double(std::abs(area_of(t))) / (2 * subpixel * subpixel);
  std::fill_n(found, triangles.size(), std::uint8_t(1));
  const double count = double(triangles.size());
  if (pixels < min_pixels * count) return;
  raise(frame, triangles, 1, found);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    kept += double(std::abs(area_of(triangles[i]))) / (2 * subpixel * subpixel) / found[i];
  // Four times the work, for sharper bounds.
  if (kept >= min_pixels_kept * count) raise(frame, triangles, 4, found);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (triangles[i].piece != DrawnTriangle::not_cut) found[i] = 1;
}

}  // namespace

bool may_stride(const Frame& frame, const Draw& draw) {
  return frame.settings.tolerance > rounding_codes && frame.colour_alone &&
         draw.object->shading == Shading::phong && !draw.illumination.constant &&
         draw.object->material.ambient_share == 0;
}

bool is_large(const DrawnTriangle& drawn) {
  return std::abs(area_of(drawn)) >= 2 * large_pixels * subpixel * subpixel;
}

int stride_in(const Frame& frame, const DrawnTriangle& drawn, const Rect& pixels) {
  if (drawn.piece != DrawnTriangle::not_cut) return 1;
  const auto& v = drawn.vertices;
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int x = std::max(left, pixels.x_begin * subpixel),
            y = std::max(top, pixels.y_begin * subpixel);
  const int end_x = std::min(right, pixels.x_end * subpixel),
            end_y = std::min(bottom, pixels.y_end * subpixel);
  constexpr int columns = Batch::lanes >= 16 ? 4 : 2, rows = Batch::lanes / columns;
  ScreenGroup group;
  group.cells = Batch::lanes;
  for (int lane = 0; lane < Batch::lanes; ++lane) {
    const int column = lane % columns, row = lane / columns;
    const auto between = [](int from, int to, int i, int of) {
      return from + (to - from) * i / of;
    };
    group.put(frame, drawn, lane);
    group.put_rectangle(drawn,
                        {between(x, end_x, column, columns), between(y, end_y, row, rows),
                         between(x, end_x, column + 1, columns), between(y, end_y, row + 1, rows)},
                        lane);
  }
  Lanes result;
  strides_of(frame, frame.draw_of(drawn), group).store(result.of);
  return int(result.of[0]);
}

int stride_of(const Frame& frame, const DrawnTriangle& drawn) {
  if (std::abs(area_of(drawn)) < 2 * min_pixels_alone * subpixel * subpixel) return 1;
  const Chunk& chunk = frame.chunks[drawn.chunk];
  const std::size_t number = chunk.number_of(drawn);
  std::atomic<std::uint8_t>& known = chunk.strides[number];
  if (const int stride = known.load(std::memory_order_relaxed)) return stride;

  const std::size_t first = number / max_lanes * max_lanes;
  const std::size_t count = std::min(max_lanes, chunk.triangles.size() - first);
  std::uint8_t found[max_lanes];
  find_strides(frame, std::span(&chunk.triangles[first], count), found);
  // Threads that ask at the same time find the same.
  for (std::size_t i = 0; i < count; ++i)
    chunk.strides[first + i].store(found[i], std::memory_order_relaxed);
  return known.load(std::memory_order_relaxed);
}

}  // namespace scanlit
