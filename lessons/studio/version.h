// What `scanlit --version` says.
#pragma once

#include <string>

namespace scanlit::studio {

/// Version, vectors in use, compiler and libraries, one a line.
std::string version_text();

}  // namespace scanlit::studio
