// Libraries that are loaded when they are first needed. OpenImageIO brings 250 others along:
// loading them takes ten times as long as a first picture, and `--help`, tables and curves need no
// image.
#pragma once

namespace scanlit {

/// What the library, a file beside this program's own libraries, calls `symbol`; loads the library
/// the first time. Throws Error where it is missing.
const void* on_demand(const char* library, const char* symbol);

}  // namespace scanlit
