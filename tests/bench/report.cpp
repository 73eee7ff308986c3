#include "report.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

#include "rasterizer/image/output_file.h"

namespace scanlit::bench {

namespace {

class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      auto& least = figures[run.run_name.function_name];
      for (const auto& [name, counter] : run.counters) {
        const auto [entry, is_new] = least.try_emplace(name, counter.value);
        if (!is_new) entry->second = std::min(entry->second, counter.value);
      }
    }
  }

  Figures figures;
};

}  // namespace

Figures run(int argc, char** argv) {
  std::string options[] = {"--benchmark_enable_random_interleaving=true",
                           "--benchmark_repetitions=15", "--benchmark_min_time=0.02"};
  std::vector<char*> arguments = {argv[0]};
  for (std::string& option : options) arguments.push_back(option.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = int(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::Shutdown();
  return collector.figures;
}

std::string machine() {
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

void write_file(const std::string& file, const std::string& text) {
  OutputFile output(file);
  std::fwrite(text.data(), 1, text.size(), output.stream());
  output.commit();
}

}  // namespace scanlit::bench
