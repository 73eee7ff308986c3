#include "bench_main.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "rasterizer/image/output_file.h"
#include "report.h"

namespace scanlit::bench {

int bench_main(int argc, char** argv, const std::string& description,
               nlohmann::json (*measure)(bool quick)) try {
  std::string json;
  bool quick = false;
  CLI::App app(description);
  app.add_option("--json", json, "file for the figures");
  app.add_flag("--quick", quick, "fewer frames, and fewer scenes");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "error: " << error.what() << "\n";
    return 2;
  }
  if (!json.empty()) OutputFile{json};  // nobody waits for figures that have nowhere to go
  const nlohmann::json figures = measure(quick);
  if (!json.empty()) write_file(json, figures.dump(2) + "\n");
  return 0;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << "\n";
  return 2;
}

}  // namespace scanlit::bench
