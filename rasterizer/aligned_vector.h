// Vectors whose elements begin at a line of the cache: processors take twice as long to load or
// store a vector that lies in two lines.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace scanlit {

constexpr std::size_t cache_line = 64;  // bytes

template <class T>
struct LineAllocator {
  using value_type = T;

  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(cache_line)));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(cache_line)); }

  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, LineAllocator<T>>;

}  // namespace scanlit
