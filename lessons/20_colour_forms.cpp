// New idea: colour can stand in Ka, Kd and Ks, or in object_color and light_color: two forms.
// Builds on: lesson 17, the three parts.
// Try: --light 1,1,1; --light .2,.5,1: which of the two would a photograph agree with?
#include <algorithm>
#include <cmath>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "models/registry.h"

using namespace scanlit;

// new idea
/// Form 1, colour in the coefficients:
///   I = Ka Ia + { Kd (N.L) + Ks (N.H)^n } Ii,  with Ia and Ii in the light's colour
Material form_1(const Rgb<double>& ka, const Rgb<double>& kd, const Rgb<double>& ks) {
  const std::string model = "blinn-phong:n=40,kd=" + studio::text_of(kd) + ",ks=";
  return {.model = models::make(model + studio::text_of(ks)).model, .ka = ka};
}

/// Form 2, colour beside them; ka, kd and ks are plain numbers:
///   I = { Ka Ia + Kd (N.L) Ii } object_color + Ks (N.H)^n Ii light_color
Material form_2(double ka, double kd, double ks, const Rgb<double>& object_color) {
  Material material = form_1(Rgb<double>(ka), Rgb<double>(kd), Rgb<double>(ks));
  material.form = ColourForm::plastic;
  material.object_colour = object_color;
  return material;
}
// end of new idea

double largest_difference(const Framebuffer& a, const Framebuffer& b) {
  float largest = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i)
    largest = std::max(largest, std::abs(a.colour[i] - b.colour[i]));
  return largest;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("The two colour forms, under white and under coloured light.", 1600, 1100);
  std::string light = "1,.42,.12";
  lesson.knob("--light", light, "light_color, red,green,blue");

  return lesson.run(argc, argv, [&] {
    const Rgb<double> light_color = studio::parse_colour("--light", light, {0, 2});
    const double ka = .12, kd = .8, ks = .6;
    const Rgb<double> object_color(.10, .30, .62);
    const auto photograph = [&](const Material& material, bool coloured, int width, int height) {
      Object teapot = studio::make_object("teapot:24", "lambert");
      teapot.material = material;
      Scene scene = studio::make_stage({teapot});
      if (coloured)
        for (Light& each : scene.lights) each.colour = light_color;
      return studio::photograph(scene, {-1, 2.2, 5}, width, height);
    };

    const Material first = form_1(object_color * ka, object_color * kd, Rgb<double>(ks));
    const Material second = form_2(ka, kd, ks, object_color);
    std::vector<Framebuffer> pictures;
    const auto draw = [&](int panel, int width, int height) {
      const Material& material = panel % 2 == 0 ? first : second;
      pictures.push_back(photograph(material, panel >= 2, width, height));
      return pictures.back();
    };
    const Framebuffer sheet = studio::panels(lesson.width(), lesson.height(), 2,
                                             {"form 1, white light", "form 2, white light",
                                              "form 1, coloured light", "form 2, coloured light"},
                                             draw);
    lesson.figure("largest difference under white light",
                  studio::fixed(largest_difference(pictures[0], pictures[1]), 4));
    lesson.figure("under coloured light",
                  studio::fixed(largest_difference(pictures[2], pictures[3]), 4));
    const Material same = form_1(object_color * ka, object_color * kd, light_color * ks);
    const auto& [width, height] = std::pair(pictures[3].width, pictures[3].height);
    lesson.figure(
        "form 2 under coloured light, form 1 under white with Ks = Ks light_color",
        studio::fixed(largest_difference(photograph(same, false, width, height), pictures[3]), 4));
    return sheet;
  });
}
