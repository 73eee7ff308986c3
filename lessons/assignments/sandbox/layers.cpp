#include "lessons/assignments/sandbox/layers.h"

namespace scanlit::sandbox {

const Layers& available() {
  static const Layers layers;
  return layers;
}

std::string describe(const Layers& layers) {
  std::string in_force, missing;
  const auto add = [&](bool is_there, const char* name) {
    std::string& list = is_there ? in_force : missing;
    list += (list.empty() ? "" : ", ") + std::string(name);
  };
  add(layers.uid, "own uid");
  add(layers.seccomp, "seccomp");
  add(layers.landlock, "Landlock");
  add(layers.bubblewrap, "bubblewrap");
  add(layers.cgroup, "cgroup");
  return (in_force.empty() ? "limits alone" : in_force) +
         (missing.empty() ? "" : "; not: " + missing);
}

}  // namespace scanlit::sandbox
