#include "models/registry.h"

#include <algorithm>

#include "models/catalogue.h"
#include "rasterizer/error.h"

namespace scanlit::models {

namespace {

// A function's statics, because models in other files register before main().
std::vector<Entry>& entries() {
  static std::vector<Entry> all;
  return all;
}
std::vector<InputEntry>& inputs() {
  static std::vector<InputEntry> all;
  return all;
}

template <class E>
std::vector<std::string> names(const std::vector<E>& all) {
  std::vector<std::string> result;
  for (const E& entry : all) result.push_back(entry.info.name);
  std::sort(result.begin(), result.end());
  return result;
}

template <class E>
const E& find(const std::vector<E>& all, const std::string& name, const std::string& what) {
  const auto named = [&](const E& entry) { return entry.info.name == name; };
  const auto found = std::find_if(all.begin(), all.end(), named);
  if (found == all.end())
    throw Error("unknown " + what + " '" + name + "'" + did_you_mean(name, names(all)));
  // A copied file whose name was not changed: one of the two would never be drawn.
  if (std::count_if(found, all.end(), named) > 1)
    throw Error(what + " '" + name + "'",
                "two of them have this name; rename one in its describe()");
  return *found;
}

/// A specification within a specification within ...: a file of a million parentheses must not
/// exhaust the stack.
constexpr int deepest = 16;

}  // namespace

bool add(Entry entry) {
  auto& all = entries();
  const auto later =
      std::upper_bound(all.begin(), all.end(), entry, [](const Entry& a, const Entry& b) {
        return std::tie(a.info.kind, a.info.year, a.info.name) <
               std::tie(b.info.kind, b.info.year, b.info.name);
      });
  all.insert(later, std::move(entry));
  return true;
}

bool add(InputEntry entry) {
  inputs().push_back(std::move(entry));
  return true;
}

const std::vector<ModelInfo>& list() {
  link_catalogue();
  static std::vector<ModelInfo> infos;
  if (infos.size() != entries().size()) {
    infos.clear();
    for (const Entry& entry : entries()) infos.push_back(entry.info);
  }
  return infos;
}

const std::vector<ModelInfo>& list_inputs() {
  static const std::vector<ModelInfo> infos = [] {
    std::vector<ModelInfo> result;
    for (const InputEntry& entry : inputs()) result.push_back(entry.info);
    return result;
  }();
  return infos;
}

NamedModel make(std::string_view text, const std::filesystem::path& folder) {
  return make(text, Context{.where = "", .folder = folder, .depth = 0});
}

NamedModel make(std::string_view text, const Context& context) {
  const Specification specification = parse_specification(text);
  const std::string& name = specification.name;
  const Entry& entry = find(entries(), name, "model");
  const std::string where = "model '" + name + "'";
  if (context.depth == deepest) throw Error(where, "models are nested too deeply");
  if (context.depth > 0 && entry.info.kind == Kind::part)
    throw Error(context.where, "'" + name + "' is a part of models and reflects nothing");
  NamedModel result =
      entry.make(entry.info, specification.arguments, {where, context.folder, context.depth + 1});
  result.specification = text;
  return result;
}

std::shared_ptr<const Input> make_input(std::string_view call, const Context& context) {
  const Specification specification = parse_call(call);
  const InputEntry& entry = find(inputs(), specification.name, "input");
  const Context inside{context.where + ", " + specification.name, context.folder, context.depth};
  return entry.make(read_values(inside, entry.info.parameters, specification.arguments));
}

bool is_input(std::string_view text) {
  const auto open = text.find('(');
  if (open != text.npos) return open > 0 && !text.starts_with('(');
  return std::any_of(inputs().begin(), inputs().end(),
                     [&](const InputEntry& entry) { return entry.info.name == text; });
}

}  // namespace scanlit::models
