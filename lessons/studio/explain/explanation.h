// scanlit explain: how one pixel comes about, as text for a lecture or as JSON. The numbers are the
// engine's own (rasterizer/pixel_record.h); only D, G and F are asked for once more, in double.
#pragma once

#include <ostream>
#include <string>

#include "lessons/studio/description.h"
#include "rasterizer/pixel_record.h"

namespace scanlit::studio {

struct Explanation {
  std::string input;  // what is drawn, as on the command line
  const Description& description;
  const Scene& scene;
  PixelRecord record;

  const Object& object_of(const FragmentRecord& f) const { return scene.objects[f.object]; }
  const models::NamedModel& model_of(const FragmentRecord& f) const {
    return description.objects[f.object].material.model;
  }
  const Picture& picture() const { return description.picture; }
};

/// R, G and B as the picture's file holds them: 0..255.
struct Codes {
  int r, g, b;
};
Codes codes_of(const float (&rgba)[4], const ImageOptions& options);

/// One light's derivation takes about 50 lines. Of several fragments that share the pixel,
/// `fragment` (0: the first) is told in full.
void print_explanation(std::ostream& out, const Explanation& explanation, std::size_t fragment);

/// All fragments, all floats with the digits that give them back.
void print_explanation_json(std::ostream& out, const Explanation& explanation);

}  // namespace scanlit::studio
