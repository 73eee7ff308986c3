// What the comparison prints and writes.
#pragma once

#include <string>
#include <vector>

#include "comparison.h"
#include "versus_targets.h"

namespace scanlit::bench {

void print_header();
void print_row(const SceneResult& result);
/// Geometric mean and least of the ratios of S1 to S8P.
void print_summary(const std::vector<SceneResult>& results);
/// Where Scanlit's time goes.
void print_stages(const std::vector<SceneResult>& results);

void print_targets(const std::vector<TargetResult>& results);

/// A page by itself, with a chart.
std::string report_page(const std::vector<SceneResult>& results,
                        const std::vector<TargetResult>& reached);

}  // namespace scanlit::bench
