// New idea: a BRDF is a function of two directions; one looks at it in cuts.
// Builds on: lessons 18 to 25; any model is looked at in the same way.
// Try: --left lambert; --middle phong:ks=.7; --right material:velvet; which lobes lean?
#include <algorithm>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/polar.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/query.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// f_r in 1/sr, out of what a model returns, pi f_r (N.L).
double f_r(const ReflectionModel& model, const Vec3<double>& l, const Vec3<double>& v) {
  return studio::luminance(studio::reflected(model, l, v)) / (std::numbers::pi * l.z);
}

/// A polar plot: the light stands still at theta_l, the viewer goes over the hemisphere, in one
/// plane with it. Beyond the normal from the light theta_v is positive.
double in_plane(const ReflectionModel& model, double theta_l, double theta_v) {
  return f_r(model, studio::direction_at(-theta_l, 0), studio::direction_at(theta_v, 0));
}

/// A slice: H leaves the normal by theta_h, and L and V leave H by theta_d, to both sides of the
/// plane of N and H (phi_d = 90 degrees). Radians.
double slice(const ReflectionModel& model, double theta_h, double theta_d) {
  const Vec3<double> H{std::sin(theta_h), 0, std::cos(theta_h)}, across{0, std::sin(theta_d), 0};
  return f_r(model, H * std::cos(theta_d) + across, H * std::cos(theta_d) - across);
}
// end of new idea

/// theta_h to the right, theta_d upwards, 0 to 90 degrees each; grey is f_r / (1 + f_r).
Framebuffer slice_picture(const ReflectionModel& model, int width, int height) {
  Framebuffer picture(width, height);
  const double right_angle = std::numbers::pi / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double value =
          slice(model, right_angle * (x + .5) / width, right_angle * (1 - (y + .5) / height));
      std::fill_n(&picture.colour[4 * (std::size_t(y) * width + x)], 3, float(value / (1 + value)));
    }
  return picture;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("A BRDF as a function: polar plots and slices.", 1740, 960);
  std::string texts[] = {"oren-nayar:rho=.9,sigma=.7", "blinn-phong:kd=.25,ks=.6,n=40",
                         "torrance-sparrow:kd=.1,ks=.5,m=.2,F=copper"};
  double light = 60;
  lesson.knob("--left", texts[0], "the model on the left");
  lesson.knob("--middle", texts[1], "the model in the middle");
  lesson.knob("--right", texts[2], "the model on the right");
  lesson.knob("--light", light, {1, 89}, "the largest of three angles of the light, in degrees");

  return lesson.run(argc, argv, [&] {
    const auto draw = [&](int panel, int width, int height) {
      const models::NamedModel named = models::make(texts[panel % 3]);
      const ReflectionModel& model = *named.model;
      if (panel >= 3) return slice_picture(model, width, height);
      const double lights[] = {.2 * light, .6 * light, light};
      double largest = 0;
      for (const double theta_l : lights)
        for (double theta_v = -89; theta_v < 90; ++theta_v)
          largest = std::max(largest, in_plane(model, theta_l, theta_v));
      lesson.figure(texts[panel] + ", largest f_r", studio::fixed(largest, 3) + " / sr");
      studio::Polar plot(width, height, largest, lesson.height());
      const Rgb<double> colours[] = {ink::blue, ink::orange, ink::vermilion};
      for (int k = 0; k < 3; ++k) {
        plot.light(lights[k], colours[k]);
        plot.lobe([&](double theta_v) { return in_plane(model, lights[k], theta_v); }, colours[k]);
      }
      return plot.finish();
    };
    const std::string cut = "theta_h right, theta_d up";
    const auto name = [&](int i) { return texts[i].substr(0, texts[i].find(':')); };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {name(0), name(1), name(2), cut, cut, cut}, draw);
  });
}
