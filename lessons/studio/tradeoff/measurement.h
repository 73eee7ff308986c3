// What `scanlit tradeoff` measures: ways to draw one picture, each with its time and its error.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rasterizer/reference/picture_error.h"

namespace scanlit::studio {

using Progress = std::function<void(double share)>;  // called with 0..1

/// One way to draw.
struct Candidate {
  std::string series;  // what a curve joins: "Gouraud"
  std::string label;   // "16,384 triangles"
  std::int64_t triangles = 0;
  bool is_default = false;
  std::function<void()> draw;             // a frame, to be timed
  std::function<ExactPicture()> picture;  // the same frame, to be looked at
  std::vector<bool> silhouette{};         // pixels to be kept apart; empty: none
};

struct Measured {
  std::string series, label;
  std::int64_t triangles = 0;
  bool is_default = false;
  double ms = 0;  // of processor time on one thread; median of `frames` frames
  int frames = 0;
  PictureError error;   // in steps of sRGB
  double flip = 0;      // mean over the picture
  bool pareto = false;  // nothing else is both faster and nearer to the truth
  ExactPicture picture;

  /// What is plotted: root mean square, in 8-bit steps of sRGB, away from silhouettes.
  double steps() const { return error.interior.rms_steps; }
};

/// All candidates in turn, three times over, so that what slows the machine down for a while slows
/// all alike.
std::vector<Measured> measure(const std::vector<Candidate>& candidates, const ExactPicture& truth,
                              const Progress& progress);

}  // namespace scanlit::studio
