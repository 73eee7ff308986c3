// New idea: D, G and F are multiplied: Specular = D G F / (N.V).
// Builds on: lessons 22, 23 and 24, one factor each.
// Try: --m .1; --m .6; --metal gold; which factor makes the highlight, which its colour?
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "models/metals.h"
#include "models/microfacet/masking.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;

enum Shown { only_D, only_G, only_F, product };

// new idea
/// Torrance and Sparrow 1967, Cook and Torrance 1982. Of the facets, D face H; light and viewer
/// both see the share G of them; each mirrors the share F. Seen from the side, they crowd: 1 / N.V.
struct Specular {
  double m;
  const models::MetalFresnel* metal;
  Shown shown = product;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    const T D = exp(-angle2(c.n_h) * T(1 / (m * m)));
    const T G = models::microfacet::v_cavity(c);
    const Rgb<T> F = (*metal)(c.v_h);
    const Rgb<T> parts[] = {Rgb<T>(D), Rgb<T>(G), F, F * (T(.8) * D * G / c.n_v)};
    return {.diffuse = {}, .glossy = parts[shown]};
  }
};
// end of new idea

double red_over_blue(const Framebuffer& picture) {
  double most = 0;
  for (std::size_t i = 0; i < picture.colour.size(); i += 4)
    if (picture.colour[i] > .5)
      most = std::max(most, double(picture.colour[i] / picture.colour[i + 2]));
  return most;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("D, G, F, their product, and a plate of teapots.", 1800, 1420);
  double m = .3;
  std::string metal = "copper";
  lesson.knob("--m", m, {.05, 1}, "roughness in the first two rows");
  lesson.knob("--metal", metal, "metal in the first two rows");

  return lesson.run(argc, argv, [&] {
    const std::vector<std::string> metals = {"copper", "gold", "silver", "aluminium"};
    std::vector<std::string> captions = {
        "D", "G", "F", "D G F / (N.V)", "D, light behind", "G", "F", "D G F / (N.V)"};
    for (const char* each : {", m = .2", ", m = .4"})
      for (const std::string& name : metals) captions.push_back(name + each);
    const auto draw = [&](int panel, int width, int height) {
      const int row = panel / 4, column = panel % 4;
      const Specular model = row < 2 ? Specular{m, &models::metal(metal), Shown(column)}
                                     : Specular{row == 2 ? .2 : .4, &models::metal(metals[column])};
      Scene scene = studio::make_stage({studio::make_object(
          "teapot:32", std::make_shared<const FormulaModel<Specular>>(model))});
      if (row == 0) scene.lights = {studio::far_light({-.5, .6, .8}, 1)};
      if (row == 1) scene.lights = {studio::far_light({-.9, .45, -.3}, 1)};
      if (row >= 2)
        scene.lights = {studio::far_light({-.6, .7, .7}, 1.1), studio::far_light({.9, .1, .4}, .7),
                        studio::far_light({-.9, .3, -.5}, .6),
                        studio::far_light({.2, -.6, .6}, .35)};
      scene.lights.push_back(studio::far_light({.1, .9, -.1}, row < 2 ? 0 : .8));
      // Drawn finer: where light ends, F ends at a hard edge, which is found pixel by pixel.
      const int finer = row < 2 ? 2 : 1;
      const Framebuffer picture = studio::reduced(
          studio::photograph(scene, {1, 2, 5}, finer * width, finer * height), finer);
      if (model.shown == only_F)
        lesson.figure(row == 0 ? "F, red over blue, light beside the viewer" : "light behind",
                      studio::fixed(red_over_blue(picture), 2));
      return picture;
    };
    return studio::panels(lesson.width(), lesson.height(), 4, captions, draw);
  });
}
