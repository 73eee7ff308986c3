// Numbers that follow from a seed, the same on every machine: what variants and questions are drawn
// with. Standard distributions differ from library to library.
#pragma once

#include <cstdint>
#include <string_view>

namespace scanlit::assignments {

/// Sebastiano Vigna's SplitMix64, "http://prng.di.unimi.it/splitmix64.c", 2015.
class Dice {
 public:
  /// Seeds that differ only in their purpose ("variant", "A1.2") have nothing in common.
  Dice(std::uint64_t seed, std::string_view purpose) : state_(seed) {
    for (const char c : purpose) state_ = (state_ ^ std::uint64_t(std::uint8_t(c))) * 0x100000001b3;
    next();
  }

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// low..high, both included; by less than 2^-40 not all equally often.
  int between(int low, int high) {
    return low + int(next() % (std::uint64_t(std::int64_t(high) - low) + 1));
  }
  /// [0, 1)
  double unit() { return double(next() >> 11) * 0x1p-53; }
  double real(double low, double high) { return low + unit() * (high - low); }
  bool coin() { return next() >> 63; }

 private:
  std::uint64_t state_;
};

}  // namespace scanlit::assignments
