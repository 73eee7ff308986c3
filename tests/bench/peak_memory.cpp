// Draws S7, its mesh made as flat arrays, and prints how many bytes the mesh has and how many the
// process had at most: started by bench_scaling.
#include <cstdio>
#include <fstream>
#include <string>

#include "bench_shapes.h"
#include "scanlit_side.h"

namespace scanlit::bench {
namespace {

std::size_t bytes(const Mesh& mesh) {
  return (mesh.positions.size() + mesh.normals.size()) * sizeof(glm::vec3) +
         mesh.indices.size() * sizeof(std::uint32_t);
}

/// "VmHWM", what the process had at most, in kB.
std::size_t peak_kb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stoul(line.substr(6));
  return 0;
}

}  // namespace
}  // namespace scanlit::bench

int main() {
  using namespace scanlit::bench;
  const BenchScene scene{
      .name = "S7",
      .shader = Shader::gouraud,
      .placements = {{.mesh = std::make_shared<scanlit::Mesh>(sphere(2001, 2500))}}};
  ScanlitSide renderer(2);
  renderer.prepare(scene);
  for (int frame = 0; frame < 3; ++frame) renderer.draw(scene, frame);
  std::printf("%zu %zu\n", bytes(*scene.placements[0].mesh), peak_kb() * 1024);
}
