#include "lessons/studio/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace scanlit::studio {
namespace {

constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

ProgressBar::ProgressBar()
    : start_(std::chrono::steady_clock::now()), terminal_(isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
  if (shown_percent_ >= 0) std::fputs(clear_line, stderr);
}

void ProgressBar::show(double share) {
  const int percent = static_cast<int>(100 * std::clamp(share, 0.0, 1.0));
  if (!terminal_ || percent == shown_percent_) return;
  if (std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  shown_percent_ = percent;
  const std::size_t width = 40, filled = width * percent / 100;
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "%srendering [%s] %3d %%", clear_line, bar.c_str(), percent);
}

}  // namespace scanlit::studio
