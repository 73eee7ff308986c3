// What the properties of depth and models look like over distance and angle.
#pragma once

#include <string>
#include <vector>

namespace scanlit::stress {

/// The least step in depth that is told apart, as a share of the distance: the engine's reversed
/// float beside what else depth is stored as, and what the engine is measured to tell apart. SVG.
std::string plot_depth();

/// How many digits float loses of one model over the viewing angle, and why.
struct Conditioning {
  std::string model, svg;
  double worst = 0;      // relative error of float or Batch
  double angle_deg = 0;  // where
  std::string why;
};
/// Of every analytic model of the registry, with its default parameters, lit from 45 degrees.
std::vector<Conditioning> plot_conditioning();

}  // namespace scanlit::stress
