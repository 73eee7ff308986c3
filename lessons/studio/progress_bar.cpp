#include "lessons/studio/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace scanlit::studio {
namespace {

constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

std::string time_left(double seconds) {
  // Longer than this nobody waits, and it fits any integer.
  const long whole = std::lround(std::ceil(std::clamp(seconds, 0.0, 1e8)));
  char text[64];
  if (whole < 60)
    std::snprintf(text, sizeof text, "%ld s left", whole);
  else if (whole < 3600)
    std::snprintf(text, sizeof text, "%ld:%02ld left", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld left", whole / 3600, whole / 60 % 60,
                  whole % 60);
  return text;
}

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)),
      start_(std::chrono::steady_clock::now()),
      terminal_(isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
  if (!shown_.empty()) std::fputs(clear_line, stderr);
}

void ProgressBar::show(double share) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (!terminal_ || elapsed.count() < 1 || !(share > 0)) return;
  share = std::min(share, 1.0);
  const std::size_t width = 40, filled = std::size_t(double(width) * share);
  char percent[16];
  std::snprintf(percent, sizeof percent, " %3d %%", static_cast<int>(100 * share));
  const std::string line = what_ + " [" + std::string(filled, '#') +
                           std::string(width - filled, '.') + ']' + percent + ", " +
                           time_left(elapsed.count() * (1 - share) / share);
  if (line == shown_) return;
  std::fprintf(stderr, "%s%s", clear_line, line.c_str());
  shown_ = line;
}

}  // namespace scanlit::studio
