// A bar on stderr for what takes longer than a second, only where stderr is a terminal.
#pragma once

#include <chrono>

namespace scanlit::studio {

class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();  // wipes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double share);  // 0..1

 private:
  std::chrono::steady_clock::time_point start_;
  bool terminal_;
  int shown_percent_ = -1;
};

}  // namespace scanlit::studio
