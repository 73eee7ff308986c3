// Where labels of points in a plot stand, so that they cover neither points nor one another.
#pragma once

#include <string>
#include <vector>

#include "lessons/studio/reflect/panel.h"

namespace scanlit::studio {

struct PlacedLabel {
  PlotPoint at;        // of the text's anchor, on its baseline
  std::string anchor;  // start, middle or end
};

class LabelPlaces {
 public:
  /// Labels stay inside of the panel; letters are `size` pixels high.
  LabelPlaces(const PanelPlace& panel, double size) : panel_(panel), size_(size) {}

  /// Nothing may cover the point.
  void keep_free(PlotPoint point, double radius);
  /// Beside the point, `gap` pixels from it, where most is free; the place is then taken.
  PlacedLabel place(PlotPoint point, const std::string& text, double gap);

 private:
  struct Box {
    double left, top, right, bottom;
  };
  double covered(const Box& box) const;

  PanelPlace panel_;
  double size_;
  std::vector<Box> taken_;
};

}  // namespace scanlit::studio
