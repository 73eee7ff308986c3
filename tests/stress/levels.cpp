#include "tests/stress/levels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "tests/stress/random_scene.h"

namespace scanlit::stress {

namespace {

template <class T>
void write(std::ofstream& out, const std::vector<T>& plane) {
  out.write(reinterpret_cast<const char*>(plane.data()), std::streamsize(plane.size() * sizeof(T)));
}
template <class T>
std::vector<T> read(std::ifstream& in, std::size_t size) {
  std::vector<T> plane(size);
  in.read(reinterpret_cast<char*>(plane.data()), std::streamsize(size * sizeof(T)));
  return plane;
}

int srgb_code(float linear) {
  const double c = std::clamp(double(linear), 0.0, 1.0);
  return int(
      std::lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
}

}  // namespace

void write_pictures(const std::string& file, int count) {
  std::ofstream out(file, std::ios::binary);
  Property property{"pictures", "random scenes", "", count};
  while (property.next()) {
    const Framebuffer f = draw(random_scene(property));
    write(out, std::vector<int>{f.width, f.height});
    write(out, f.object_id), write(out, f.triangle_id), write(out, f.depth), write(out, f.colour);
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

bool pictures_agree(const std::string& one, const std::string& other) {
  std::ifstream a(one, std::ios::binary), b(other, std::ios::binary);
  std::size_t pictures = 0, pixels = 0, visibility = 0, by_one = 0, by_more = 0;
  for (;; ++pictures) {
    const auto size = read<int>(a, 2), same = read<int>(b, 2);
    if (!a && !b) break;
    if (!a || !b || size != same) throw std::runtime_error("not of the same pictures: " + other);
    const std::size_t count = std::size_t(size[0]) * std::size_t(size[1]);
    const auto ids_a = read<std::uint32_t>(a, 3 * count), ids_b = read<std::uint32_t>(b, 3 * count);
    for (std::size_t i = 0; i < 3 * count; ++i) visibility += ids_a[i] != ids_b[i];
    const auto colour_a = read<float>(a, 4 * count), colour_b = read<float>(b, 4 * count);
    for (std::size_t i = 0; i < 4 * count; ++i) {
      const int steps = std::abs(srgb_code(colour_a[i]) - srgb_code(colour_b[i]));
      by_one += steps == 1, by_more += steps > 1;
    }
    pixels += count;
  }
  std::cout << pictures << " pictures, " << pixels << " pixels: " << visibility
            << " ids or depths differ, " << by_one << " channels by one 8-bit step, " << by_more
            << " by more\n";
  return pictures > 0 && visibility == 0 && by_more == 0;
}

}  // namespace scanlit::stress
