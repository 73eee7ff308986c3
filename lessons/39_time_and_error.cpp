// New idea: of many ways to draw a picture, only those count that no other beats in time and error.
// Builds on: lessons 11 and 12, Gouraud and Phong; lesson 37, an error and its unit.
// Try: --measure 1, for times of your own machine: does the front change?
#include <algorithm>
#include <cmath>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/tradeoff/study_scene.h"
#include "rasterizer/reference/analytic.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
struct Way {
  std::string shading, triangles;
  double ms, error;  // of a frame; in 8-bit steps, root mean square

  /// At least as fast and as right as b, and more so in one of the two: nobody would choose b.
  bool beats(const Way& b) const {
    return ms <= b.ms && error <= b.error && (ms < b.ms || error < b.error);
  }
};

/// The Pareto front: those that no other beats, fastest first. Along it a better picture takes
/// longer, always. Which of them is the best no formula says: that is a choice.
std::vector<Way> pareto_front(const std::vector<Way>& ways) {
  std::vector<Way> front;
  for (const Way& b : ways)
    if (std::ranges::none_of(ways, [&](const Way& a) { return a.beats(b); })) front.push_back(b);
  std::ranges::sort(front, {}, &Way::ms);
  return front;
}
// end of new idea

/// A teapot of n segments, and what a frame of it took, in ms: one thread of an AMD EPYC (Zen 5).
struct Teapot {
  int n;
  double gouraud_ms, phong_ms;
};
constexpr Teapot teapots[] = {{2, .78, 1.02},   {3, 1.01, 1.22},  {4, 1.20, 1.46},
                              {6, 1.65, 1.81},  {8, 1.98, 2.11},  {12, 2.63, 2.63},
                              {16, 3.17, 2.97}, {24, 4.16, 3.65}, {32, 5.86, 4.44},
                              {48, 9.98, 6.86}, {64, 14.3, 9.11}};

studio::StudyScene teapot(int n, Shading shading = Shading::phong) {
  studio::StudyScene study = studio::study_scene("teapot:" + std::to_string(n));
  study.scene.objects[0].shading = shading;
  return study;
}

/// The least of a few frames: whatever else runs on the machine makes them longer, never shorter.
double measured_ms(const studio::StudyScene& study) {
  Renderer renderer;
  Framebuffer picture(studio::study_width, studio::study_height);
  double least = INFINITY;
  for (int i = 0; i < 12; ++i)
    least = std::min(
        least, renderer.render(study.scene, study.camera, {.threads = 1}, picture).wall_seconds);
  return 1e3 * least;
}

std::vector<Way> draw_all(studio::Lesson& lesson, bool measure) {
  const studio::StudyScene fine = teapot(64);
  constexpr int width = studio::study_width, height = studio::study_height;
  const ExactPicture right = render_analytic(fine.scene, fine.camera, width, height);
  std::vector<Way> ways;
  for (const auto& [n, gouraud_ms, phong_ms] : teapots) {
    const auto outline = silhouettes(right, studio::reference_of(teapot(n)), fine.camera);
    for (const Shading shading : {Shading::gouraud, Shading::phong}) {
      const bool gouraud = shading == Shading::gouraud;
      const studio::StudyScene study = teapot(n, shading);
      Framebuffer drawn(width, height, {.ids = true});
      const FrameStats stats = render(study.scene, study.camera, {}, drawn);
      const PictureError e = compare(right, exact_picture(drawn), Encoding::srgb, outline);
      ways.push_back({gouraud ? "Gouraud" : "Phong", studio::grouped(stats.triangles),
                      gouraud ? gouraud_ms : phong_ms, e.interior.rms_steps});
      if (!measure) continue;
      ways.back().ms = measured_ms(study);
      lesson.time(ways.back().shading + ", " + ways.back().triangles, ways.back().ms);
    }
  }
  return ways;
}

Framebuffer chart_of(const std::vector<Way>& ways, const std::vector<Way>& front, bool measured,
                     int width, int height, int sheet_height) {
  const auto [least, most] = std::ranges::minmax(ways, {}, &Way::ms);
  const double from = std::min(.6, .8 * least.ms), to = std::max(20.0, 1.3 * most.ms);
  studio::Chart chart(width, height,
                      {from, to, measured ? "ms a frame, here" : "ms a frame, AMD EPYC", true},
                      {.015, 15, "error, in 8-bit steps", true}, sheet_height);
  std::vector<glm::dvec2> stairs;
  for (const Way& way : front) {
    if (!stairs.empty()) stairs.emplace_back(way.ms, stairs.back().y);
    stairs.emplace_back(way.ms, way.error);
  }
  chart.curve(stairs, ink::yellow, 14);
  chart.line({from, .5}, {to, .5}, ink::soft, 2);
  chart.words({from * 31 / 30, .54}, "half a step of 8 bits", ink::soft);
  for (const bool gouraud : {true, false}) {
    const Rgb<double>& colour = gouraud ? ink::vermilion : ink::blue;
    std::vector<glm::dvec2> curve;
    for (const Way& way : ways)
      if ((way.shading == "Gouraud") == gouraud) curve.emplace_back(way.ms, way.error);
    chart.curve(curve, colour, 4);
    for (const glm::dvec2& point : curve) chart.dot(point, colour, 9);
    chart.words({curve.back().x * 1.08, curve.back().y * .95}, gouraud ? "Gouraud" : "Phong",
                colour);
  }
  for (const Way& way : ways)
    if (way.triangles == "4,032" || way.triangles == "16,256") {
      const bool left = way.shading == "Phong";
      chart.words({way.ms * (left ? .96 : 1.04), way.error * (left ? .9 : 1)},
                  way.triangles + " triangles", ink::black, left ? Align::right : Align::left);
    }
  return chart.finish();
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Run time against error, and the Pareto front.", 1800, 1240);
  int measure = 0;
  lesson.knob("--measure", measure, {0, 1}, "1: measure times here, and do not take those known");

  return lesson.run(argc, argv, [&] {
    const std::vector<Way> ways = draw_all(lesson, measure), front = pareto_front(ways);
    const auto on_front = [&](const std::string& shading) {
      return std::to_string(std::ranges::count(front, shading, &Way::shading)) + " of " +
             std::to_string(std::size(teapots));
    };
    const Way& phong = ways[9];
    const auto as_right = std::ranges::find_if(
        ways, [&](const Way& way) { return way.shading == "Gouraud" && way.error <= phong.error; });
    lesson.figure("Phong, " + phong.triangles + " triangles, error in steps",
                  studio::fixed(phong.error, 2));
    lesson.figure("the first Gouraud as right has", as_right->triangles + " triangles");
    if (!measure)
      lesson.figure("on the front",
                    on_front("Gouraud") + " Gouraud, " + on_front("Phong") + " Phong");
    const int below = lesson.height() * 36 / 100;
    const auto draw = [&](int panel, int width, int height) {
      const Teapot& shown = teapots[std::array{0, 4, 10}[panel]];
      const studio::StudyScene study =
          teapot(shown.n, panel == 0 ? Shading::gouraud : Shading::phong);
      Framebuffer picture(width, height);
      render(study.scene, study.camera, {.samples = 16}, picture);
      return picture;
    };
    return studio::stacked(
        chart_of(ways, front, measure, lesson.width(), lesson.height() - below, lesson.height()),
        studio::panels(lesson.width(), below, 3,
                       {"Gouraud, 240 triangles", "Phong, 4,032", "Phong, 261,632"}, draw,
                       ink::slate, lesson.height()));
  });
}
