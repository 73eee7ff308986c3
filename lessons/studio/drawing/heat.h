// A quantity in false colours: dark where there is little, light where there is much.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/framebuffer.h"
#include "rasterizer/vec.h"

namespace scanlit::studio {

/// At most nine bands, each with the largest value that belongs to it (the last has no end).
/// Colours are picks from the scale "plasma" of Matplotlib, which the colour-blind can order, with
/// a grey below it.
class HeatScale {
 public:
  static constexpr int most_bands = 9;
  struct Band {
    double most;
    std::string label;
  };
  explicit HeatScale(std::vector<Band> bands) : bands_(std::move(bands)) {}

  const std::vector<Band>& bands() const { return bands_; }
  Rgb<double> colour_of_band(std::size_t band) const;  // linear light
  Rgb<double> colour(double value) const;

  /// A value a pixel, row by row; below 0: there is none.
  Framebuffer draw(const std::vector<double>& values, int width, int height) const;

  /// The bands side by side under a title, with their labels, as for a sheet of sheet_height
  /// pixels.
  Framebuffer legend(const std::string& title, int width, int height, int sheet_height) const;

 private:
  std::vector<Band> bands_;
};

/// Of counts: 0, 1, 2, 3-4, 5-8, ... As the pictures of `scanlit render --aov cost` have it.
HeatScale count_scale(int bands = HeatScale::most_bands);

}  // namespace scanlit::studio
