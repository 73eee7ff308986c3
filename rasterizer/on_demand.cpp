#include "rasterizer/on_demand.h"

#include <dlfcn.h>

#include "rasterizer/error.h"

namespace scanlit {

const void* on_demand(const char* library, const char* symbol) {
  // Never closed: libraries of OpenImageIO leave threads and exit handlers behind.
  void* const handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  const void* const found = handle ? dlsym(handle, symbol) : nullptr;
  if (!found) throw Error(library, std::string("cannot be loaded: ") + dlerror());
  return found;
}

}  // namespace scanlit
