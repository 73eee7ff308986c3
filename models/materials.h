// Materials by name: material:NAME is a model with its parameters chosen for one real surface.
//
//   material:copper           material:copper,m=.2       further values take the place of its own
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/registry.h"

namespace scanlit::models {

struct NamedMaterial {
  std::string name;                    // "copper"
  std::string specification;           // the model, as one would write it
  std::string source;                  // author, year; or "chosen by eye"
  std::optional<Tangents> tangents{};  // how it is brushed
};

/// All of them, in the order in which they are listed.
const std::vector<NamedMaterial>& materials();

/// The model that material:NAME stands for, as one would write it; any other specification as it
/// is. Throws Error where there is no such material.
std::string model_behind(const std::string& specification);

Entry material_entry();
inline const bool material_registered = add(material_entry());

}  // namespace scanlit::models
