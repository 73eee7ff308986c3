// The main() of the benchmarks that print a table.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace scanlit::bench {

/// Parses --json FILE and --quick, prints the table and writes what `measure` returns to FILE.
/// Returns the exit status.
int bench_main(int argc, char** argv, const std::string& description,
               nlohmann::json (*measure)(bool quick));

}  // namespace scanlit::bench
