// Vectors for what is much read and written: their elements begin at a line of the cache, for
// processors take twice as long over a vector that lies in two lines, and large ones lie in huge
// pages, of whose addresses a processor remembers more.
#pragma once

#include <cstddef>
#include <vector>

namespace scanlit {

constexpr std::size_t cache_line = 64;  // bytes

/// Throws std::bad_alloc.
void* allocate_lines(std::size_t bytes);
void free_lines(void* lines, std::size_t bytes);

template <class T>
struct LineAllocator {
  using value_type = T;

  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_lines(count * sizeof(T))); }
  void deallocate(T* p, std::size_t count) { free_lines(p, count * sizeof(T)); }

  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, LineAllocator<T>>;

}  // namespace scanlit
