#include "lessons/assignments/grade/write_file.h"

#include "lessons/studio/program.h"
#include "rasterizer/image/output_file.h"

namespace scanlit::assignments {

void write_file(const std::filesystem::path& file, std::string_view text) {
  const studio::HoldInterrupts until_written;
  OutputFile output(file);
  std::fwrite(text.data(), 1, text.size(), output.stream());
  output.commit();
}

}  // namespace scanlit::assignments
