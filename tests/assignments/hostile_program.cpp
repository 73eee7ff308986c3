#include "tests/assignments/hostile_program.h"

#include <fstream>

namespace scanlit::test {

HostileProgram::HostileProgram(const std::string& source, const sandbox::Layers& layers)
    : box_(std::filesystem::temp_directory_path(), {}, for_compiler(), layers) {
  std::ofstream(box_.scratch() / "source.cpp") << source;
  build_ = box_.run({SCANLIT_CXX, "-std=c++20", "-O1", "source.cpp", "-o", "program"});
}

sandbox::Outcome HostileProgram::run(const sandbox::Limits& limits) {
  box_.limits() = limits;
  return box_.run({program().string()});
}

sandbox::Conversation HostileProgram::start(const sandbox::Limits& limits) {
  box_.limits() = limits;
  return box_.start({program().string()});
}

}  // namespace scanlit::test
