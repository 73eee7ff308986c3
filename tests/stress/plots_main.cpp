// stress_plots FOLDER: depth.svg, a plot of each model's conditioning, and index.html, which shows
// them all.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/stress/plots.h"

int main(int argc, char** argv) {
  using namespace scanlit::stress;
  if (argc != 2) return std::cerr << "error: stress_plots wants a folder\n", 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "depth.svg") << plot_depth();

  std::ofstream page(folder / "index.html");
  page << "<!doctype html><meta charset=\"utf-8\"><title>Numbers under stress</title>\n"
          "<style>body{font-family:sans-serif;margin:2em}td,th{padding:.2em .8em;text-align:left}"
          "img{max-width:48%}</style>\n<h1>Depth</h1>\n<img src=\"depth.svg\">\n"
          "<p>Perspective makes depth 1/distance, densest where the eye is; float is densest "
          "towards 0. Reversed, the two cancel: the step is the same share of every distance.</p>\n"
          "<h1>Where models lose digits</h1>\n<p>Of the glossy part, where it is more than 1e-5 of "
          "its peak.</p>\n"
          "<table><tr><th>model<th>worst relative error<th>at<th>why\n";
  const auto models = plot_conditioning();
  for (std::size_t i = 0; i < models.size(); ++i) {
    char row[80];
    std::snprintf(row, sizeof row, "<td>%.1e<td>%.0f&deg;<td>", models[i].worst,
                  models[i].angle_deg);
    page << "<tr><td>" << models[i].model << row << models[i].why << '\n';
  }
  page << "</table>\n";
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string name = "model_" + std::to_string(i) + ".svg";
    std::ofstream(folder / name) << models[i].svg;
    page << "<img src=\"" << name << "\">\n";
  }
  if (!page.flush()) return std::cerr << "error: cannot write in " << folder << '\n', 2;
}
