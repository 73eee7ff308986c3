#include "lessons/studio/tradeoff/temporary_folder.h"

#include <cstdlib>
#include <cstring>

#include "rasterizer/error.h"

namespace scanlit::studio {

TemporaryFolder::TemporaryFolder() {
  std::error_code ignored;
  std::string name = (std::filesystem::temp_directory_path(ignored) / "scanlit-XXXXXX").string();
  if (!mkdtemp(name.data())) throw Error(name, std::strerror(errno));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace scanlit::studio
