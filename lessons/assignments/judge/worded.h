// Sentences with numbers in them, as printf makes them.
#pragma once

#include <string>

namespace scanlit::assignments {

[[gnu::format(printf, 1, 2)]] std::string worded(const char* format, ...);

}  // namespace scanlit::assignments
