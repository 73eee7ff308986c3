// New idea: a BRDF need not be a formula; a table of samples does, if it is looked up well.
// Builds on: lesson 28, a BRDF as a function; lessons 22 to 25, the formula that is measured here.
// Try: --m .05; --model blinn-phong:ks=.4,n=500: where does the table lose most?
#include <algorithm>
#include <cmath>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/query.h"
#include "models/measured/merl.h"

using namespace scanlit;
using models::MerlTable;

// new idea
/// What a gonioreflectometer does: for each bin of angles it sets up light and viewer, and writes
/// down f_r. No texture, no formula, no parameters: 1,458,000 numbers a channel.
MerlTable measured(const ReflectionModel& surface) {
  MerlTable table{std::vector<Rgb<double>>(MerlTable::size, Rgb<double>(-1))};  // -1: not measured
  for (int h = 0; h < MerlTable::theta_h_bins; ++h)
    for (int d = 0; d < MerlTable::theta_d_bins; ++d)
      for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
        const auto [l, v] = models::directions(MerlTable::centre(h, d, p));
        if (l.z < min_n_v || v.z < min_n_v) continue;  // below the horizon
        const Rgb<double> f_r = studio::reflected(surface, l, v) * (1 / (std::numbers::pi * l.z));
        const Rgb<double>& scale = MerlTable::scale;
        table.entries[MerlTable::index(h, d, p)] = {f_r.r / scale.r, f_r.g / scale.g,
                                                    f_r.b / scale.b};
      }
  return table;
}
// end of new idea

/// Both over theta_h, where L and V leave H by 30 degrees, across.
Framebuffer lobe(const ReflectionModel& formula, const ReflectionModel& table, int width,
                 int height, int sheet_height) {
  const auto green = [](const ReflectionModel& model, double theta_h) {
    const auto [l, v] = models::directions({studio::radians_of(theta_h), .52, 1.58});
    return studio::reflected(model, l, v).g;
  };
  studio::Chart chart(width, height, {0, 6, "theta_h, degrees"},
                      {0, 1.1 * green(formula, 0), "pi f_r (N.L)"}, sheet_height);
  for (const ReflectionModel* model : {&table, &formula}) {
    std::vector<glm::dvec2> curve;
    for (double deg = 0; deg <= 6; deg += .02) curve.emplace_back(deg, green(*model, deg));
    chart.curve(curve, model == &table ? studio::ink::vermilion : studio::ink::blue, 8);
  }
  return chart.finish();
}

int main(int argc, char** argv) {
  studio::Lesson lesson("A measured table against the formula it came from.", 1740, 1000);
  std::string text = "torrance-sparrow:kd=.12/.015/.02,m=.12,eta=2";
  double times = 20;
  lesson.knob("--model", text, "what is measured: isotropic");
  lesson.knob("--times", times, {1, 1000}, "how much brighter differences are shown");

  return lesson.run(argc, argv, [&] {
    const auto formula = models::make(text).model;
    const MerlTable table = measured(*formula);
    const std::shared_ptr<const ReflectionModel> three[] = {
        formula, std::make_shared<models::Merl>(table, models::MerlLookup::nearest),
        std::make_shared<models::Merl>(table, models::MerlLookup::trilinear)};
    Framebuffer pictures[3];
    const std::string names[] = {"the formula", "table, nearest bin", "table, between bins"};
    const auto draw = [&](int panel, int width, int height) {
      const int i = panel % 3;
      if (panel < 3) {
        Scene scene = studio::make_stage({studio::make_object("teapot:32", three[i])});
        scene.ambient = Rgb<double>(0);  // a table has no diffuse part to reflect it
        return pictures[i] = studio::photograph(scene, {-1.8, 2.2, 3.6}, width, height);
      }
      if (i == 0) return lobe(*three[0], *three[1], width, height, lesson.height());
      double largest = 0;
      const Framebuffer error = studio::difference(pictures[i], pictures[0], times, largest);
      lesson.figure(names[i] + ", largest error", studio::fixed(largest, 3));
      return error;
    };
    const std::string more = "its error, x " + studio::text_of(times);
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {names[0], names[1], names[2], "nearest bin, formula", more, more}, draw);
  });
}
