#include "lessons/studio/explain/explanation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lessons/studio/explain/point_text.h"
#include "lessons/studio/explain/rows.h"
#include "lessons/studio/table.h"
#include "lessons/studio/text.h"
#include "rasterizer/image/image_encoding.h"

namespace scanlit::studio {
namespace {

const char* name(Shading shading) {
  return shading == Shading::flat ? "flat" : shading == Shading::gouraud ? "Gouraud" : "Phong";
}

/// Where the pixel's triangle is, and what it hides.
class Visibility {
 public:
  Visibility(std::ostream& out, const Explanation& all) : rows_(out), all_(all) {}

  void samples() const {
    rows_.title("Samples", {"x / px", "y / px", "depth z/w"});
    const auto& samples = all_.record.samples;
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const SampleRecord& sample = samples[s];
      const double x = all_.record.x + 0.5 + double(sample.offset.x) / subpixel,
                   y = all_.record.y + 0.5 + double(sample.offset.y) / subpixel;
      const std::string label = "sample " + std::to_string(s);
      if (sample.layers.empty()) {
        rows_.numbers(label, {x, y}, "the background");
        continue;
      }
      const std::size_t behind = sample.layers.size() - 1;
      rows_.numbers(
          label, {x, y, double(sample.layers[0].depth)},
          text_of_layer(sample.layers[0]) + (behind ? ", hides " + std::to_string(behind) : ""));
    }
  }

  void fragment(const FragmentRecord& f) const {
    const Object& object = all_.object_of(f);
    rows_.title("Visibility", {"x / px", "y / px", "depth z/w"});
    rows_.text("object", std::to_string(f.object) + ", " + object.name + ", " +
                             name(object.shading) + " shading");
    rows_.text("triangle",
               std::to_string(f.triangle) + ", " +
                   (f.back_facing ? "a back face: its normals are flipped" : "a front face") +
                   (f.clipped ? "; a piece of it, cut off by the view's sides" : ""));
    for (std::size_t k = 0; k < 3; ++k) {
      const ScreenVertex& v = f.screen.vertices[k];
      const std::string vertex =
          f.clipped ? std::string("corner")
                    : "vertex " + std::to_string(object.mesh->indices[3 * f.triangle + k]);
      rows_.numbers(std::string(1, char('A' + k)) + " = " + vertex,
                    {double(v.x) / subpixel, double(v.y) / subpixel, double(v.depth)},
                    k == 0 ? "snapped to 1/256 px" : "");
    }
    const bool centred = f.x_begin <= all_.record.x && all_.record.x < f.x_end;
    rows_.text("span", f.x_begin < f.x_end
                           ? "row " + std::to_string(all_.record.y) + ", columns " +
                                 std::to_string(f.x_begin) + ".." + std::to_string(f.x_end - 1)
                           : "none: it covers no pixel centre of this row, but samples");
    rows_.numbers("barycentric A, B, C", {double(1 - f.b1 - f.b2), double(f.b1), double(f.b2)},
                  !centred    ? "at the centroid of its samples"
                  : f.clipped ? "in the triangle before it was cut"
                              : "");
    if (all_.record.samples.size() == 1) layers();
  }

 private:
  static std::string text_of_layer(const LayerRecord& layer) {
    return "triangle " + std::to_string(layer.triangle) + " of object " +
           std::to_string(layer.object);
  }

  /// Of one sample.
  void layers() const {
    constexpr std::size_t most = 6;
    const auto& layers = all_.record.samples[0].layers;
    rows_.numbers("depth", {double(layers[0].depth)}, "1 at the near plane, 0 at the far one");
    if (layers.size() == 1) rows_.text("hides", "nothing that was drawn");
    for (std::size_t i = 1; i < std::min(layers.size(), most + 1); ++i)
      rows_.numbers("hides", {double(layers[i].depth)}, text_of_layer(layers[i]));
    if (layers.size() > most + 1)
      rows_.text("", "and " + plural(layers.size() - most - 1, "triangle") + " more");
  }

  Rows rows_;
  const Explanation& all_;
};

std::string ambient_remark(const Material& material) {
  const bool tinted = material.form == ColourForm::tinted;
  const std::string light = tinted ? " Ia" : " Ia object_colour";
  if (material.ambient_share == 0) return "Ka" + light;
  return "(Ka + " + text_of(material.ambient_share) + " of the model head-on)" + light;
}

void print_radiance(std::ostream& out, const Explanation& all, const FragmentRecord& f) {
  const Rows rows(out);
  const Object& object = all.object_of(f);
  const bool gouraud = object.shading == Shading::gouraud;
  rows.title(gouraud ? "Radiance, interpolated" : "Radiance", rgb);
  if (gouraud) {
    const float b[3] = {1 - f.b1 - f.b2, f.b1, f.b2};
    for (std::size_t k = 0; k < 3; ++k)
      rows.colour(std::string("colour at ") + char('A' + k), f.points[k].colour,
                  "x " + fixed(double(b[k]), 6) + ", ambient " +
                      short_text(double(f.points[k].ambient.r), 4) + "/" +
                      short_text(double(f.points[k].ambient.g), 4) + "/" +
                      short_text(double(f.points[k].ambient.b), 4));
  } else {
    rows.colour("ambient", f.ambient, ambient_remark(object.material));
    rows.colour("+ diffuse", f.diffuse, plural(all.scene.lights.size(), "light"));
    rows.colour("+ glossy", f.glossy);
  }
  rows.colour("= colour", f.colour, "", 9);
}

void print_pixel(std::ostream& out, const Explanation& all) {
  const Rows rows(out);
  const PixelRecord& record = all.record;
  rows.title("Pixel", rgb);
  const float covered = record.covered[3];
  for (std::size_t k = 0;
       k < record.fragments.size() && (covered < 1 || k > 0 || record.fragments.size() > 1); ++k) {
    const FragmentRecord& f = record.fragments[k];
    rows.colour("fragment " + std::to_string(k), f.colour,
                "x " + short_text(double(f.weight)) + ", triangle " + std::to_string(f.triangle) +
                    " of object " + std::to_string(f.object));
  }
  if (covered < 1) {
    const Rgb<double>& b = all.scene.background;
    rows.colour("background", {float(b.r), float(b.g), float(b.b)},
                "x " + short_text(double(1 - covered)));
  }
  rows.colour("linear", {record.colour[0], record.colour[1], record.colour[2]},
              "float, as scanlit render draws it", 9);
  const ImageOptions& image = all.picture().image;
  const Codes codes = codes_of(record.colour, image);
  char hexadecimal[16];
  std::snprintf(hexadecimal, sizeof hexadecimal, "#%02x%02x%02x", unsigned(codes.r),
                unsigned(codes.g), unsigned(codes.b));
  rows.numbers(
      image.encoding == Encoding::srgb ? "sRGB, 8 bits" : "linear, 8 bits",
      {double(codes.r), double(codes.g), double(codes.b)},
      hexadecimal + (image.exposure_ev != 0 ? ", after exposure " + text_of(image.exposure_ev)
                                            : std::string()),
      0);
}

}  // namespace

Codes codes_of(const float (&rgba)[4], const ImageOptions& options) {
  const EightBitEncoder encode(options.encoding);
  const auto exposure = float(std::exp2(options.exposure_ev));
  return {encode(exposure * rgba[0]), encode(exposure * rgba[1]), encode(exposure * rgba[2])};
}

void print_explanation(std::ostream& out, const Explanation& all, std::size_t fragment) {
  const PixelRecord& record = all.record;
  out << "Pixel " << record.x << "," << record.y << " of " << all.input << ", "
      << all.picture().width << " x " << all.picture().height << " pixels, "
      << plural(record.samples.size(), "sample") << " a pixel";
  if (record.fragments.empty()) {
    const Codes codes = codes_of(record.colour, all.picture().image);
    out << ", shows the background: " << codes.r << " " << codes.g << " " << codes.b
        << " in 8 bits\n";
    return;
  }
  out << '\n';
  const FragmentRecord& f = record.fragments[fragment];
  print_wrapped(out, "Model " + all.model_of(f).specification, "");
  const Visibility visibility(out, all);
  if (record.samples.size() > 1) visibility.samples();
  visibility.fragment(f);
  print_points(out, all, f);
  print_radiance(out, all, f);
  print_pixel(out, all);
}

}  // namespace scanlit::studio
