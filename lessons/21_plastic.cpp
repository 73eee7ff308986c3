// New idea: whoever gives every surface a white highlight makes everything of plastic.
// Builds on: lesson 20, where colour stands in the model.
// Try: --n 200; --metals aluminium,iron,nickel: how much do these three lose by a white Ks?
#include <algorithm>
#include <sstream>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "models/metals.h"

using namespace scanlit;

// new idea
/// Plastic: a clear binder mirrors some of the light as it came, white; the rest enters, meets
/// pigments, and comes out in their colour and in all directions.
std::string plastic(const Rgb<double>& colour, double n) {
  return "blinn-phong:kd=" + studio::text_of(colour * .4) + ",ks=.5,n=" + studio::text_of(n);
}

/// A metal lets nothing out again. All of its light is mirrored at the surface, and that is where
/// its colour comes from: Ks has it, and Kd stands only for the room that it mirrors.
std::string metal(const Rgb<double>& colour, double n) {
  return "blinn-phong:kd=" + studio::text_of(colour * .12) + ",ks=" + studio::text_of(colour) +
         ",n=" + studio::text_of(n / 4);
}
// end of new idea

/// Red over blue of the picture's brightest pixel.
double red_over_blue(const Framebuffer& picture) {
  const float* brightest = &picture.colour[0];
  for (std::size_t i = 0; i < picture.colour.size(); i += 4)
    if (picture.colour[i + 1] > brightest[1]) brightest = &picture.colour[i];
  return brightest[0] / brightest[2];
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Why a white highlight means plastic.", 1800, 1000);
  std::string chosen = "copper,gold,silver";
  double n = 90;
  lesson.knob("--metals", chosen, "three metals");
  lesson.knob("--n", n, {4, 1000}, "exponent of the plastic's highlight; a metal's is a quarter");

  return lesson.run(argc, argv, [&] {
    std::vector<std::string> names, captions;
    std::istringstream list(chosen + ",,,");
    for (std::string name; names.size() < 3 && std::getline(list, name, ',');)
      names.push_back(name);
    for (const std::string& name : names) captions.push_back("in the colour of " + name);
    for (const std::string& name : names) captions.push_back(name);
    return studio::panels(
        lesson.width(), lesson.height(), 3, captions, [&](int panel, int width, int height) {
          const std::string& name = names[std::size_t(panel % 3)];
          const Rgb<double> seen = models::spectral_rgb(models::find_metal(name), 1);
          const Rgb<double> colour(std::min(seen.r, 1.0), std::min(seen.g, 1.0),
                                   std::min(seen.b, 1.0));
          Scene scene = studio::make_stage({studio::make_object(
              "teapot:32", panel < 3 ? plastic(colour, n) : metal(colour, n))});
          scene.lights.push_back(studio::far_light({.1, -.2, .9}, .25));
          const Framebuffer picture = studio::photograph(scene, {-1, 2.4, 5}, width, height);
          lesson.figure(captions[std::size_t(panel)] + ", highlight's red over blue",
                        studio::fixed(red_over_blue(picture), 2));
          return picture;
        });
  });
}
