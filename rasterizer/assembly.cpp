// (6) Bins: vertices become triangles; what cannot be seen is dropped, what is cut is cut (4), and
// the rest is sorted into the tiles it may touch.
#include <algorithm>
#include <atomic>

#include "rasterizer/scan_conversion.h"

namespace scanlit {

namespace {

/// Why a triangle, or a piece of one, is or is not drawn; a cut triangle counts as the largest of
/// its pieces'.
enum class Fate { outside, no_pixel, back_facing, drawn };

/// The pixels whose sample positions the triangle's box can hold; may be empty.
Rect pixel_bounds(const ScreenTriangle& t, int samples) {
  if (samples == 1) return centre_bounds(t);
  // More samples than one lie anywhere in their pixel.
  const auto [a, b, c] = t.vertices;
  const auto [x_min, x_max] = std::minmax({a.x, b.x, c.x});
  const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
  return {x_min >> 8, y_min >> 8, (x_max >> 8) + 1, (y_max >> 8) + 1};
}

bool empty(const Rect& r) { return r.x_begin >= r.x_end || r.y_begin >= r.y_end; }

Fate bin(const Frame& frame, const Draw& draw, TriangleId id, const ScreenTriangle& triangle,
         Chunk& chunk) {
  if (triangle.twice_area == 0) return Fate::no_pixel;
  const bool back_facing = (triangle.twice_area < 0) != draw.mirrored;
  if (back_facing && !draw.draw_back_faces) return Fate::back_facing;

  Rect r = pixel_bounds(triangle, frame.settings.samples);
  if (empty(r)) return Fate::no_pixel;
  r = {std::max(r.x_begin, 0), std::max(r.y_begin, 0), std::min(r.x_end, frame.viewport.width),
       std::min(r.y_end, frame.viewport.height)};
  if (empty(r)) return Fate::outside;

  const TileGrid& grid = frame.grid;
  for (int row = r.y_begin / grid.tile_height; row <= (r.y_end - 1) / grid.tile_height; ++row)
    for (int column = r.x_begin / grid.tile_width; column <= (r.x_end - 1) / grid.tile_width;
         ++column)
      chunk.bins[std::size_t(row) * std::size_t(grid.columns) + std::size_t(column)].push_back(id);
  return Fate::drawn;
}

/// Flat and Gouraud: the sites whose colour a drawn triangle will ask for.
void mark_sites(const Draw& draw, std::uint32_t triangle, bool back_facing, LitSites& sites) {
  const auto mark = [&](std::size_t site, std::uint8_t how) {
    // Chunks share vertices, so two threads may mark one site.
    std::atomic_ref<std::uint8_t>(sites.needed[site]).store(how, std::memory_order_relaxed);
  };
  if (draw.object->shading == Shading::flat)
    mark(triangle, back_facing ? LitSites::from_behind : LitSites::from_front);
  if (draw.object->shading == Shading::gouraud)
    for (int corner = 0; corner < 3; ++corner)
      mark(vertex_site(draw, triangle, corner, back_facing), LitSites::from_front);
}

}  // namespace

void assemble(std::uint32_t begin, std::uint32_t end, Frame& frame, Chunk& chunk) {
  chunk.bins.resize(std::size_t(frame.grid.count()));
  std::int64_t fates[4] = {};
  const Draw* draw = nullptr;
  std::uint32_t draw_end = begin;
  for (std::uint32_t id = begin; id < end; ++id) {
    if (id >= draw_end) {
      draw = &frame.draw_of(id);
      draw_end = draw->first_triangle + std::uint32_t(draw->mesh->triangle_count());
    }
    const std::uint32_t triangle = id - draw->first_triangle;
    const std::uint32_t* index = &draw->mesh->indices[3 * std::size_t(triangle)];
    const std::uint8_t* codes = &frame.outcodes[draw->first_vertex];
    const unsigned a = codes[index[0]], b = codes[index[1]], c = codes[index[2]];

    Fate fate = Fate::outside;
    bool front = false, back = false;
    const auto add = [&](TriangleId part, const ScreenTriangle& t) {
      const Fate part_fate = bin(frame, *draw, part, t, chunk);
      fate = std::max(fate, part_fate);
      if (part_fate == Fate::drawn) ((t.twice_area < 0) != draw->mirrored ? back : front) = true;
    };
    if ((a | b | c) == 0) {
      add(id, frame.triangle(id));
    } else if ((a & b & c) == 0 && ((a | b | c) & out_of_range) == 0) {
      const auto first = chunk.pieces.size();
      const auto& positions = draw->mesh->positions;
      clip({transform(*draw, positions[index[0]]), transform(*draw, positions[index[1]]),
            transform(*draw, positions[index[2]])},
           a | b | c, frame.viewport, id, chunk.pieces);
      for (auto i = first; i < chunk.pieces.size(); ++i) {
        const auto& v = chunk.pieces[i].vertices;
        add(TriangleId(i) | is_piece, screen_triangle(v[0], v[1], v[2]));
      }
      chunk.counts.clipped += fate == Fate::drawn;
    }
    ++fates[int(fate)];
    if (front) mark_sites(*draw, triangle, false, frame.lit_sites[draw->index]);
    if (back) mark_sites(*draw, triangle, true, frame.lit_sites[draw->index]);
  }
  chunk.counts.triangles = end - begin;
  chunk.counts.outside = fates[int(Fate::outside)];
  chunk.counts.no_pixel = fates[int(Fate::no_pixel)];
  chunk.counts.back_facing = fates[int(Fate::back_facing)];
  chunk.counts.drawn = fates[int(Fate::drawn)];
}

Rect TileGrid::tile(int index) const {
  const int x = index % columns * tile_width, y = index / columns * tile_height;
  return {x, y, std::min(x + tile_width, viewport.width),
          std::min(y + tile_height, viewport.height)};
}

TileGrid make_tile_grid(const Viewport& viewport, int samples) {
  // Depth and id of a tile's samples, 8 bytes each, should fill about half of a 1 MiB second-level
  // cache; whole scanlines where 16 of them fit.
  const int budget = 64 * 1024 / samples;
  const int min_height = 16;
  TileGrid grid{.tile_width = std::min(viewport.width, budget / min_height),
                .tile_height = 0,
                .columns = 0,
                .rows = 0,
                .viewport = viewport};
  grid.tile_height = std::clamp(budget / grid.tile_width, min_height, 32);
  grid.columns = (viewport.width + grid.tile_width - 1) / grid.tile_width;
  grid.rows = (viewport.height + grid.tile_height - 1) / grid.tile_height;
  return grid;
}

const Draw& Frame::draw_of(std::uint32_t triangle) const {
  const auto after =
      std::upper_bound(draws.begin(), draws.end(), triangle,
                       [](std::uint32_t t, const Draw& draw) { return t < draw.first_triangle; });
  return *(after - 1);
}

ScreenTriangle Frame::triangle(TriangleId id) const {
  if (id & is_piece) {
    const auto& v = pieces[id ^ is_piece].vertices;
    return screen_triangle(v[0], v[1], v[2]);
  }
  const Draw& draw = draw_of(id);
  const std::uint32_t* index = &draw.mesh->indices[3 * std::size_t(id - draw.first_triangle)];
  const ScreenVertex* v = &screen_vertices[draw.first_vertex];
  return screen_triangle(v[index[0]], v[index[1]], v[index[2]]);
}

}  // namespace scanlit
