// The threads of one frame.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <xmmintrin.h>

#include <atomic>
#include <cstddef>

namespace scanlit {

/// Subnormal results become 0 for as long as it lives: the tails of sharp lobes are subnormal, and
/// cost many times a normal number's time.
class FlushSubnormals {
 public:
  FlushSubnormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040); }
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;
  ~FlushSubnormals() { _mm_setcsr(saved_); }

 private:
  unsigned saved_;
};

/// Runs work(i) for each i below count, on all threads of the arena that it is called in. A thread
/// that is free takes the next i: the last ones should be the least, or others wait for them. What
/// work throws is thrown here, once all threads have stopped.
template <class Work>
void parallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  tbb::parallel_for(0, tbb::this_task_arena::max_concurrency(), [&](int) {
    const FlushSubnormals flush;
    try {
      for (std::size_t i; (i = next++) < count;) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  });
}

}  // namespace scanlit
