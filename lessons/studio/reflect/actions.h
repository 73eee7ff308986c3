// What `scanlit reflect` can be told to do.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace scanlit::studio {

struct ReflectOptions {
  std::vector<std::string> models;
  std::string output, rows, plot, table, precision = "double", quantity = "value", angles, azimuth,
                                         cell, exposure;
  bool logarithmic = false, terms = false, furnace = false, reciprocity = false;
  CLI::App* app = nullptr;

  bool given(const std::string& option) const;
};

// Each throws Error; text goes to -o or the terminal, everything else to -o.
void print_values(const ReflectOptions& options);
void print_furnace(const ReflectOptions& options);
void print_reciprocity(const ReflectOptions& options);
void print_terms(const ReflectOptions& options);
void plot(const ReflectOptions& options);
void write_table(const ReflectOptions& options);

}  // namespace scanlit::studio
