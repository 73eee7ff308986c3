// Looking into tables: between which rows a coordinate lies, and one look-up per vector lane.
//
// Every coordinate is brought into range before it becomes an index, also NaN: the lanes beyond a
// span's end hold anything.
#pragma once

#include <array>
#include <tuple>

#include "rasterizer/batch.h"
#include "rasterizer/scalar_math.h"
#include "rasterizer/vec.h"

namespace scanlit::models {

/// Two neighbouring rows of a table; `share`, in [0, 1], is the second one's.
template <class T>
struct Neighbours {
  int row[2];
  T share;

  T weight(int which) const { return which == 0 ? T(1) - share : share; }
};

/// Row i's value belongs to coordinate i; before the first row and after the last it is held.
template <class T>
Neighbours<T> neighbours(T coordinate, int rows) {
  const T held = min(max(coordinate, T(0)), T(rows - 1));
  const int first = held < T(rows - 1) ? int(held) : rows - 2;
  return {{first, first + 1}, held - T(first)};
}

/// The same on a circle: row 0 follows the last. Coordinate in [-rows, 2 rows].
template <class T>
Neighbours<T> periodic_neighbours(T coordinate, int rows) {
  if (coordinate < T(0)) coordinate = coordinate + T(rows);
  if (coordinate >= T(rows)) coordinate = coordinate - T(rows);
  const T held = min(max(coordinate, T(0)), T(rows));
  const int first = int(held);
  return {{first % rows, (first + 1) % rows}, held - T(first)};
}

/// The row whose interval [i, i + 1) holds the coordinate; the first or last row beyond.
template <class T>
int containing_row(T coordinate, int rows) {
  return int(min(max(coordinate, T(0)), T(rows - 1)));
}

/// look_up(angles...) for a scalar, and for each lane of a vector: gathers would need the table in
/// float, and indices of each lane all the same.
template <class T, std::size_t count, class LookUp>
Rgb<T> for_each_lane(const std::array<T, count>& angles, const LookUp& look_up) {
  return std::apply(look_up, angles);
}
template <std::size_t count, class LookUp>
Rgb<Batch> for_each_lane(const std::array<Batch, count>& angles, const LookUp& look_up) {
  float in[count][Batch::lanes], r[Batch::lanes], g[Batch::lanes], b[Batch::lanes];
  for (std::size_t i = 0; i < count; ++i) angles[i].store(in[i]);
  for (int lane = 0; lane < Batch::lanes; ++lane) {
    std::array<float, count> of_lane;
    for (std::size_t i = 0; i < count; ++i) of_lane[i] = in[i][lane];
    const Rgb<float> value = std::apply(look_up, of_lane);
    r[lane] = value.r, g[lane] = value.g, b[lane] = value.b;
  }
  return {Batch::load(r), Batch::load(g), Batch::load(b)};
}

}  // namespace scanlit::models
