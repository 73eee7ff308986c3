// Scanlit beside Mesa's llvmpipe, OpenGL on the processor: the same scenes (bench_scenes.h), frame
// by frame in turn, on one thread and on two.
//
// llvmpipe takes its number of threads from the environment, so each number has a process of its
// own, which this program starts. In that environment malloc keeps what it got from the system, for
// both renderers, as it does in a program that has been drawing for a while.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "child_process.h"
#include "comparison.h"
#include "rasterizer/error.h"
#include "rasterizer/image/output_file.h"
#include "versus_report.h"

namespace scanlit::bench {
namespace {

struct Options {
  std::string json, html;
  bool quick = false;
  std::vector<std::string> scenes;
  int child_threads = 0;  // above 0: this is a process that measures
};

/// Prints a line of JSON for every scene.
void measure(const Options& options) {
  ScanlitSide scanlit(options.child_threads);
  OsmesaPeer peer;
  const Effort effort = options.quick ? Effort{1, 5, 30} : Effort{8, 9, 150};
  for (const std::string& name : options.scenes)
    std::cout << nlohmann::json(compare_scene(make_bench_scene(name), options.child_threads, effort,
                                              scanlit, peer))
              << std::endl;
}

/// Milliseconds from the start of a program that draws one picture to that picture, the least of
/// several.
double first_frame_ms(const char* program, const std::vector<std::string>& settings) {
  const auto file = std::filesystem::path(this_program()).parent_path() / program;
  double least = 1e30;
  for (int i = 0; i < 7; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run_process({file.string()}, settings, [&](const std::string& line) {
      if (line != "drawn\n") throw Error(program, "drew nothing");
      const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
      least = std::min(least, ms.count());
    });
  }
  return least;
}

void compare_first_frames() {
  std::printf("\nfirst frame, program start to pixels (S2), best of 7: Scanlit %.0f ms, ",
              first_frame_ms("first_frame_scanlit", {}));
  const std::vector<std::string> settings = {"LP_NATIVE_VECTOR_WIDTH=256", "LP_NUM_THREADS=2"};
  std::printf("llvmpipe %.0f ms,\n", first_frame_ms("first_frame_llvmpipe", settings));
  auto without_cache = settings;
  without_cache.emplace_back("MESA_SHADER_CACHE_DISABLE=true");
  std::printf("  without shaders that an earlier run has compiled %.0f ms\n",
              first_frame_ms("first_frame_llvmpipe", without_cache));
}

std::vector<SceneResult> compare_on(int threads, const Options& options) {
  std::vector<std::string> command = {this_program(), "--measure-on", std::to_string(threads)};
  if (options.quick) command.emplace_back("--quick");
  for (const std::string& scene : options.scenes) command.insert(command.end(), {"--scene", scene});
  std::vector<SceneResult> results;
  run_process(command,
              {"LP_NUM_THREADS=" + std::to_string(threads), "LP_NATIVE_VECTOR_WIDTH=256",
               "MALLOC_TRIM_THRESHOLD_=4000000000",
               "MALLOC_MMAP_THRESHOLD_=33554432",  // the largest that glibc takes
               // Mesa 22.3 would take code that it compiled for another vector width from there.
               "MESA_SHADER_CACHE_DISABLE=true"},
              [&](const std::string& line) {
                results.push_back(nlohmann::json::parse(line));
                print_row(results.back());
              });
  return results;
}

void run(const Options& options) {
  // Nobody waits for figures that have nowhere to go.
  for (const std::string& file : {options.json, options.html})
    if (!file.empty()) OutputFile{file};
  std::vector<SceneResult> results;
  print_header();
  for (const int threads : {1, 2}) {
    const auto part = compare_on(threads, options);
    print_summary(part);
    results.insert(results.end(), part.begin(), part.end());
  }
  print_stages(results);
  compare_first_frames();
  if (!options.json.empty()) write_file(options.json, nlohmann::json(results).dump(2) + "\n");
  if (!options.html.empty()) write_file(options.html, report_page(results));
}

Options parse(int argc, char** argv) {
  Options options;
  CLI::App app("Scanlit beside llvmpipe, frame by frame");
  app.add_option("--json", options.json, "file for the figures");
  app.add_option("--html", options.html, "file for a page that shows them");
  app.add_flag("--quick", options.quick, "fewer frames, and without S7");
  app.add_option("--scene", options.scenes, "only this scene (may be repeated)")
      ->check(CLI::IsMember(scene_names()));
  app.add_option("--measure-on", options.child_threads)->group("");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) std::exit(app.exit(error));
    throw Error(error.what());
  }
  if (options.scenes.empty()) {
    options.scenes = scene_names();
    if (options.quick) std::erase(options.scenes, "S7");
  }
  return options;
}

}  // namespace
}  // namespace scanlit::bench

int main(int argc, char** argv) try {
  using namespace scanlit::bench;
  const Options options = parse(argc, argv);
  options.child_threads > 0 ? measure(options) : run(options);
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << "\n";
  return 2;
}
