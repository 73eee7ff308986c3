// Every model of the registry, none left out, with the specifications it is tested with.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "models/measured/tabulate.h"
#include "tests/unit/model_queries.h"

namespace scanlit::test {

struct Tested {
  models::ModelInfo info;
  std::vector<std::string> specifications;  // first the default
  bool measured = false;                    // a table, whose claims are those of its data
};

/// A table of each format, tabulated when it is first asked for, gone with the process.
class TableFiles {
 public:
  static std::string file(const std::string& format) {
    static TableFiles files;
    const auto file = files.folder_ / (format + ".bin");
    if (!std::filesystem::exists(file)) {
      const auto source = models::make("blinn-phong:kd=.3/.2/.1,ks=.3,n=20,normalised=1").model;
      format == "merl" ? models::tabulate_merl(*source, file)
                       : models::tabulate_utia(*source, file);
    }
    return file.string();
  }
  ~TableFiles() { std::filesystem::remove_all(folder_); }

 private:
  TableFiles() { std::filesystem::create_directories(folder_); }
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("scanlit-tables-" + std::to_string(getpid()));
};

inline bool wants_file(const models::ModelInfo& info) {
  return std::any_of(info.parameters.begin(), info.parameters.end(), [](const auto& p) {
    return p.kind == models::ParameterKind::file && p.initial == models::Value("");
  });
}

inline Tested tested(const std::string& name) {
  const auto& all = models::list();
  const auto found = std::find_if(all.begin(), all.end(), [&](auto& i) { return i.name == name; });
  Tested result{*found, {}, wants_file(*found)};
  if (result.measured)
    for (const char* lookup : {"nearest", "trilinear"}) {
      if (name == "merl" || lookup[0] == 't')
        result.specifications.push_back(name + ":file=" + TableFiles::file(name) +
                                        (name == "merl" ? std::string(",lookup=") + lookup : ""));
    }
  else if (!found->example.empty())
    result.specifications = {found->example};
  else
    result.specifications = specifications(*found);
  return result;
}

/// The names of all models but measured tables, which are as reciprocal and as bright as their
/// data, and whose steps merl_test and utia_test know.
inline std::vector<std::string> analytic_names() {
  std::vector<std::string> names;
  for (const auto& info : models::list())
    if (info.kind == models::Kind::model && !wants_file(info)) names.push_back(info.name);
  return names;
}
/// The names of all models, or of the parts of models.
inline std::vector<std::string> names_of(models::Kind kind) {
  std::vector<std::string> names;
  for (const auto& info : models::list())
    if (info.kind == kind) names.push_back(info.name);
  return names;
}
inline std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& info : models::list()) names.push_back(info.name);
  return names;
}

/// A test's parameter as a word that GoogleTest takes.
inline std::string word(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace scanlit::test
