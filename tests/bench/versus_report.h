// What the comparison prints and writes.
#pragma once

#include <string>
#include <vector>

#include "comparison.h"

namespace scanlit::bench {

void print_header();
void print_row(const SceneResult& result);
/// Geometric mean and least of the ratios of all scenes that draw something.
void print_summary(const std::vector<SceneResult>& results);
/// Where Scanlit's time goes.
void print_stages(const std::vector<SceneResult>& results);

/// A page by itself, with a chart.
std::string report_page(const std::vector<SceneResult>& results);

/// Throws Error naming the file.
void write_file(const std::string& file, const std::string& text);

}  // namespace scanlit::bench
