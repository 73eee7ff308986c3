// What the benchmarks share: running them, and keeping of every figure the best repetition.
#pragma once

#include <map>
#include <string>

#include "rasterizer/vector_level.h"

namespace scanlit::bench {

/// Of each benchmark, by its name: each counter's least value over all repetitions. On a machine
/// that others use too the least is what repeats.
using Figures = std::map<std::string, std::map<std::string, double>>;

/// Runs all registered benchmarks, their repetitions in random order, so that a busy moment does
/// not hit one of two that are compared. Takes Google Benchmark's options besides.
Figures run(int argc, char** argv);

/// The processor's name.
std::string machine();

/// Throws Error naming the file.
void write_file(const std::string& file, const std::string& text);

}  // namespace scanlit::bench
