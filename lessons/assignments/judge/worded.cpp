#include "lessons/assignments/judge/worded.h"

#include <cstdarg>
#include <cstdio>

namespace scanlit::assignments {

std::string worded(const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::string text(std::size_t(std::vsnprintf(nullptr, 0, format, arguments)), ' ');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  va_end(arguments);
  return text;
}

}  // namespace scanlit::assignments
