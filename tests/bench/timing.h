// Clocks, and what is kept of what they say.
#pragma once

#include <chrono>
#include <thread>
#include <vector>

namespace scanlit::bench {

using Clock = std::chrono::steady_clock;

inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of all the process's threads.
double cpu_ms();

/// Of at least one value.
double median(std::vector<double> values);
double least(const std::vector<double>& values);

/// Milliseconds per frame: by the clock, and of all the process's threads.
struct FrameTime {
  double median_ms = 0, min_ms = 0, cpu_ms = 0;  // cpu_ms is a median, too
};

/// The frames of one way to draw.
class Times {
 public:
  template <class Draw>
  void measure(const Draw& draw) {
    // So that another renderer's worker threads, which look for work a while longer, are asleep.
    std::this_thread::sleep_for(std::chrono::microseconds(500));
    const double cpu = cpu_ms();
    const auto start = Clock::now();
    draw();
    wall_ms_.push_back(ms_since(start));
    cpu_ms_.push_back(cpu_ms() - cpu);
  }

  FrameTime summary() const { return {median(wall_ms_), least(wall_ms_), median(cpu_ms_)}; }
  double last_ms() const { return wall_ms_.back(); }

 private:
  std::vector<double> wall_ms_, cpu_ms_;
};

/// How often something is measured: until `seconds` have passed, within these bounds.
struct Effort {
  double seconds;
  int min_rounds, max_rounds;
};

/// Calls round(0), round(1), ...; returns how often.
template <class Round>
int repeat(const Effort& effort, const Round& round) {
  const auto start = Clock::now();
  int count = 0;
  while (count < effort.min_rounds ||
         (count < effort.max_rounds && ms_since(start) < 1e3 * effort.seconds))
    round(count++);
  return count;
}

}  // namespace scanlit::bench
