// (6) Assembly: which tiles a chunk's triangles go to.
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

/// Sorts the triangles of one chunk after the other into its bins. Kept from chunk to chunk for its
/// memory.
class Binner {
 public:
  void begin_chunk(const TileGrid& grid);
  /// What follows does not share entries with what came before.
  void begin_cluster() { first_placed_ = std::uint32_t(placed_.size()); }

  /// Triangles may touch `entry.touched`, which is not empty and lies in the picture: all of them
  /// go to every tile there.
  void add(const BinEntry& entry);

  /// Fills the bins and their entries.
  void end_chunk(Chunk& chunk);

 private:
  /// Whether a rectangle in the picture lies in one tile.
  bool in_one_tile(const Rect& pixels) const;

  /// What a tile gets of a cluster, before the tiles are in order.
  struct Placed {
    std::uint32_t tile;
    BinEntry entry;
  };
  /// A bin, and the last of its entries, in placed_.
  struct OpenBin {
    Bin bin;
    std::uint32_t last = 0;
  };
  void place(int tile, const BinEntry& entry);

  TileGrid grid_{};
  std::vector<Placed> placed_;
  std::vector<OpenBin> bins_;           // of all tiles; empty between chunks
  int first_tile_ = 0, last_tile_ = 0;  // that have any
  std::uint32_t first_placed_ = 0;      // of the present cluster
};

}  // namespace scanlit
