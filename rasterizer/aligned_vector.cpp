#include "rasterizer/aligned_vector.h"

#include <sys/mman.h>

#include <new>

namespace scanlit {

namespace {

constexpr std::size_t huge_page = 2 << 20;  // bytes

std::align_val_t alignment(std::size_t bytes) {
  return std::align_val_t(bytes < huge_page ? cache_line : huge_page);
}

}  // namespace

void* allocate_lines(std::size_t bytes) {
  void* const lines = ::operator new(bytes, alignment(bytes));
  // A wish: where it is not granted, everything goes on in small pages.
  if (bytes >= huge_page) madvise(lines, bytes / huge_page * huge_page, MADV_HUGEPAGE);
  return lines;
}

void free_lines(void* lines, std::size_t bytes) { ::operator delete(lines, alignment(bytes)); }

}  // namespace scanlit
