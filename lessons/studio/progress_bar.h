// A bar on stderr for what takes longer than a second, only where stderr is a terminal.
#pragma once

#include <chrono>
#include <string>

namespace scanlit::studio {

class ProgressBar {
 public:
  explicit ProgressBar(std::string what = "rendering");
  ~ProgressBar();  // wipes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// 0..1. The time left is what the rest takes at the pace since the bar was made.
  void show(double share);

 private:
  std::string what_;
  std::chrono::steady_clock::time_point start_;
  bool terminal_;
  std::string shown_;
};

/// "1:02:03 left", "2:03 left" or "3 s left".
std::string time_left(double seconds);

}  // namespace scanlit::studio
