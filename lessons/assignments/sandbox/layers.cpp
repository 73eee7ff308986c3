#include "lessons/assignments/sandbox/layers.h"

#include <unistd.h>

#include <filesystem>

#include "lessons/assignments/sandbox/cgroup.h"
#include "lessons/assignments/sandbox/landlock.h"
#include "lessons/assignments/sandbox/sandbox.h"
#include "lessons/assignments/sandbox/seccomp_filter.h"

namespace scanlit::sandbox {
namespace {

/// Whether a program can be started so.
bool works(const Layers& layers) {
  try {
    constexpr double generous = 20;  // a machine that is busy
    Sandbox box(std::filesystem::temp_directory_path(), {}, {.wall_seconds = generous}, layers);
    return box.run({"/bin/true"}).good();
  } catch (const Error&) {
    return false;
  } catch (const std::filesystem::filesystem_error&) {
    return false;
  }
}

/// Adds a layer to those that were found to work, where it works with them.
void try_to_add(Layers& layers, bool Layers::*layer) {
  Layers more = layers;
  more.*layer = true;
  if (works(more)) layers = more;
}

Layers try_all() {
  Layers layers;
  if (geteuid() == 0) try_to_add(layers, &Layers::uid);
  if (!seccomp_filter(true).empty()) try_to_add(layers, &Layers::seccomp);
  if (find_cgroup_place().processes) try_to_add(layers, &Layers::cgroup_processes);
  if (find_cgroup_place().memory) try_to_add(layers, &Layers::cgroup_memory);
  try_to_add(layers, &Layers::bubblewrap);
  if (!layers.bubblewrap && has_landlock()) try_to_add(layers, &Layers::landlock);
  return layers;
}

struct Name {
  bool Layers::*layer;
  const char *name, *reason;  // why it may not be there
};

constexpr Name names[] = {
    {&Layers::uid, "own uid", "wants root"},
    {&Layers::seccomp, "seccomp", "wants libseccomp, and a kernel that lets it"},
    {&Layers::landlock, "Landlock", "wants Linux 5.13 with Landlock"},
    {&Layers::bubblewrap, "bubblewrap", "wants /usr/bin/bwrap, and user namespaces"},
    {&Layers::cgroup_processes, "cgroup of processes", "wants a control group that is ours"},
    {&Layers::cgroup_memory, "cgroup of memory", "wants a control group that is ours"}};

}  // namespace

const Layers& available() {
  static const Layers layers = try_all();
  return layers;
}

bool has_landlock() { return bool(landlock_rules({}, {})); }

std::string in_force(const Layers& layers) {
  std::string list;
  for (const Name& each : names)
    if (layers.*each.layer) list += (list.empty() ? "" : ", ") + std::string(each.name);
  return list.empty() ? "limits alone" : list;
}

std::vector<std::string> not_in_force(const Layers& layers) {
  std::vector<std::string> list;
  for (const Name& each : names) {
    if (layers.*each.layer) continue;
    const bool replaced = each.layer == &Layers::landlock && layers.bubblewrap;
    list.push_back(std::string(each.name) + ": " +
                   (replaced ? "bubblewrap is in its place" : each.reason));
  }
  return list;
}

}  // namespace scanlit::sandbox
