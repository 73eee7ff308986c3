#include "rasterizer/binning.h"

#include <algorithm>
#include <limits>

namespace scanlit {

void Binner::begin_chunk(const TileGrid& grid) {
  grid_ = grid;
  placed_.clear();
  bins_.resize(std::max(bins_.size(), std::size_t(grid.count())));
  first_tile_ = std::numeric_limits<int>::max(), last_tile_ = 0;
}

bool Binner::in_one_tile(const Rect& r) const {
  return grid_.row(r.y_begin) == grid_.row(r.y_end - 1) &&
         grid_.column(r.x_begin) == grid_.column(r.x_end - 1);
}

void Binner::add(const BinEntry& entry) {
  const Rect& r = entry.touched;
  if (in_one_tile(r))
    return place(grid_.row(r.y_begin) * grid_.columns + grid_.column(r.x_begin), entry);
  for (int row = grid_.row(r.y_begin); row <= grid_.row(r.y_end - 1); ++row)
    for (int column = grid_.column(r.x_begin); column <= grid_.column(r.x_end - 1); ++column) {
      BinEntry part = entry;
      part.touched = intersection(r, grid_.tile(column, row));
      part.pixels = std::int32_t(area(part.touched)) * std::int32_t(entry.end - entry.begin);
      place(row * grid_.columns + column, part);
    }
}

void Binner::place(int tile, const BinEntry& entry) {
  auto& [bin, last] = bins_[std::size_t(tile)];
  const bool first = bin.end == 0;
  bin.touched = first ? entry.touched : united(bin.touched, entry.touched);
  if (!first && last >= first_placed_ && placed_[last].entry.end == entry.begin) {
    BinEntry& grown = placed_[last].entry;
    grown.end = entry.end;
    grown.nearest = std::max(grown.nearest, entry.nearest);
    grown.touched = united(grown.touched, entry.touched);
    grown.pixels += entry.pixels;
    return;
  }
  ++bin.end;
  last = std::uint32_t(placed_.size());
  placed_.push_back({std::uint32_t(tile), entry});
  first_tile_ = std::min(first_tile_, tile), last_tile_ = std::max(last_tile_, tile);
}

/// A counting sort by tile; in each tile the order stays.
void Binner::end_chunk(Chunk& chunk) {
  chunk.bins.clear();
  chunk.entries.resize(placed_.size());
  if (placed_.empty()) return;
  const auto first = bins_.begin() + first_tile_, end = bins_.begin() + last_tile_ + 1;
  chunk.first_tile = first_tile_;
  std::uint32_t position = 0;
  for (auto open = first; open != end; ++open) {
    Bin& bin = chunk.bins.emplace_back(open->bin);
    bin.begin = bin.end = position;
    position += open->bin.end;
  }
  std::fill(first, end, OpenBin());
  Bin* const bins = chunk.bins.data() - first_tile_;
  for (const Placed& p : placed_) chunk.entries[bins[p.tile].end++] = p.entry;
}

}  // namespace scanlit
