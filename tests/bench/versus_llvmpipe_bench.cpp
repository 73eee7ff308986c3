// Scanlit beside Mesa's llvmpipe, OpenGL on the processor: the same scenes (bench_scenes.h), frame
// by frame in turn, on one thread and on two.
//
// llvmpipe takes its number of threads from the environment, so each number has a process of its
// own, which this program starts. In that environment malloc keeps what it got from the system, for
// both renderers, as it does in a program that has been drawing for a while.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "bench_room.h"
#include "child_process.h"
#include "comparison.h"
#include "rasterizer/error.h"
#include "rasterizer/image/output_file.h"
#include "report.h"
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
  Comparison comparison(options.child_threads,
                        options.quick ? Effort{1, 5, 30} : Effort{8, 9, 150});
  for (const std::string& name : options.scenes)
    std::cout << nlohmann::json(comparison.run(make_bench_scene(name))) << std::endl;
}

/// Milliseconds from the start of a program that draws one picture to that picture, the least of
/// several.
double first_frame_ms(const char* program, const std::vector<std::string>& settings) {
  const auto file = std::filesystem::path(this_program()).parent_path() / program;
  double shortest = 1e30;
  for (int i = 0; i < 7; ++i) {
    const auto start = Clock::now();
    run_process({file.string()}, settings, [&](const std::string& line) {
      if (line != "drawn\n") throw Error(program, "drew nothing");
      shortest = std::min(shortest, ms_since(start));
    });
  }
  return shortest;
}

FirstFrames compare_first_frames() {
  std::vector<std::string> settings = {"LP_NATIVE_VECTOR_WIDTH=256", "LP_NUM_THREADS=2"};
  FirstFrames result{.scanlit_ms = first_frame_ms("first_frame_scanlit", {}),
                     .cached_ms = first_frame_ms("first_frame_llvmpipe", settings)};
  settings.emplace_back("MESA_SHADER_CACHE_DISABLE=true");
  result.compiling_ms = first_frame_ms("first_frame_llvmpipe", settings);
  std::printf(
      "\nfirst frame, program start to pixels (S2), best of 7: Scanlit %.0f ms, llvmpipe %.0f ms\n"
      "  (%.0f ms with the shaders that an earlier run has compiled)\n",
      result.scanlit_ms, result.compiling_ms, result.cached_ms);
  return result;
}

void print_census() {
  const Census census = count_teapots(make_bench_scene("S9"));
  std::printf("S9: of %d teapots %d are visible, %d hidden, %d outside the view\n", teapot_count,
              census.visible, census.hidden, census.outside);
}

/// The list of scenes; S2's on two threads tells of the first frame besides.
void write_json(const std::string& file, const std::vector<SceneResult>& results,
                const FirstFrames& first) {
  nlohmann::json all = results;
  for (nlohmann::json& one : all) {
    one["machine"] = machine();
    one["vectors"] = vector_level();
    if (one["scene"] == "S2" && one["threads"] == 2)
      one["first_frame_ms"] = {{"scanlit", first.scanlit_ms},
                               {"llvmpipe_compiling", first.compiling_ms},
                               {"llvmpipe_cached", first.cached_ms}};
  }
  write_file(file, all.dump(2) + "\n");
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
  if (std::ranges::count(options.scenes, "S9")) print_census();
  const FirstFrames first_frames = compare_first_frames();
  const std::vector<TargetResult> reached = targets(results, first_frames);
  print_targets(reached);
  if (!options.json.empty()) write_json(options.json, results, first_frames);
  if (!options.html.empty()) write_file(options.html, report_page(results, reached));
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
