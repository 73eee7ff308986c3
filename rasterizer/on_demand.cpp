#include "rasterizer/on_demand.h"

#include <dlfcn.h>

#include "rasterizer/error.h"

namespace scanlit {

const void* on_demand(const char* library, const char* symbol) {
  // Never closed: libraries of OpenImageIO leave threads and exit handlers behind.
  void* const handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  const void* const found = handle ? dlsym(handle, symbol) : nullptr;
  if (!found) {
    const char* const why = dlerror();
    throw Error(library, std::string("cannot be loaded: ") + (why ? why : "it has no table"));
  }
  return found;
}

}  // namespace scanlit
