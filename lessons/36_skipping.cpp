// New idea: what is skipped must not show; and that is checked not by eye but bit by bit.
// Builds on: lesson 7, the depth buffer; lesson 35, shading once.
// Try: --rows 2; --rows 10; which switches save more in a larger scene, and which do not?
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "lessons/studio/drawing/heat.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;

struct Frame {
  Framebuffer picture;
  FrameStats stats;

  std::vector<double> depth_tests() const {  // at each pixel
    std::vector<double> tests;
    for (std::size_t i = 0; i < picture.cost.size(); i += 2) tests.push_back(picture.cost[i]);
    return tests;
  }
};

// new idea
/// The same bits, in every colour and every depth. Where two pictures may differ a little, somebody
/// has to say how much, and has to look again after every change. Here nobody has to.
bool same(const Framebuffer& a, const Framebuffer& b) {
  const auto same_bits = [](const std::vector<float>& x, const std::vector<float>& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(float)) == 0;
  };
  return same_bits(a.colour, b.colour) && same_bits(a.depth, b.depth);
}

/// What a frame did, kind by kind.
std::vector<double> work(const Frame& frame) {
  const FrameStats& s = frame.stats;
  const std::vector<double> tests = frame.depth_tests();
  return {double(s.clusters),  double(s.vertices),
          double(s.drawn),     std::accumulate(tests.begin(), tests.end(), 0.0),
          double(s.fragments), double(s.evaluations - s.evaluations_skipped) / double(s.fragments)};
}
constexpr const char* kinds[] = {"clusters",    "vertices",  "triangles",
                                 "depth tests", "fragments", "lights"};
// end of new idea

struct Saving {
  std::string name, words = "nothing but time";
  double times = 1;  // as much work of some kind without the switch

  Saving(const std::string& of, const Frame& with, const Frame& without) : name(of) {
    const std::vector<double> before = work(with), after = work(without);
    for (std::size_t k = 0; k < before.size(); ++k) {
      if (after[k] < std::max(times, 1.05) * before[k]) continue;
      times = after[k] / before[k];
      // Of large ones not all digits: lights are skipped by whole vectors, long or short ones.
      times =
          times < 10 ? std::round(10 * times) / 10 : std::min(10 * std::floor(times / 10), 100.0);
      words = (times < 10 ? studio::fixed(times, 1) : "over " + studio::fixed(times, 0)) +
              " x the " + kinds[k];
    }
    if (!same(with.picture, without.picture)) words += "; ANOTHER PICTURE";
  }
};

/// Pots, knots and rings around the viewer, on a floor, under lamps that light a pool each.
Scene make_crowd(int rows) {
  const float apart = 2.5;
  Scene scene = studio::make_stage({studio::make_object("plane:24", "lambert:kd=.35/.33/.30")});
  scene.lights.clear();
  scene.objects[0].world_from_object =
      glm::scale(glm::rotate(glm::mat4(1), glm::radians(-90.f), {1, 0, 0}),
                 glm::vec3(apart * float(rows + 2)));
  const Object kinds_of_objects[] = {
      studio::make_object("teapot:12", "blinn-phong:ks=.5,n=60,kd=.45/.10/.04"),
      studio::make_object("trefoil:48", "blinn-phong:ks=.5,n=60,kd=.05/.16/.24"),
      studio::make_object("torus:32", "blinn-phong:ks=.5,n=60,kd=.5/.46/.36")};
  for (int i = -rows; i <= rows; ++i)
    for (int j = -rows; j <= rows; ++j) {
      Object object = kinds_of_objects[(i * i + j * j) % 3];
      const glm::vec3 place(apart * float(i), .78f, apart * float(j));
      object.world_from_object = glm::rotate(glm::translate(glm::mat4(1), place),
                                             float(2 * i + 5 * j), glm::vec3(0, 1, 0));
      scene.objects.push_back(object);
      if ((i + j) % 2 != 0) continue;
      scene.lights.push_back({.kind = LightKind::spot,
                              .intensity = .9,
                              .direction = {0, -1, 0},
                              .position = glm::dvec3(place) + glm::dvec3(.6, 5, .6),
                              .inner_deg = 12,
                              .outer_deg = 28});
    }
  return scene;
}

/// A bar for each switch, as long as the logarithm of what it saves.
Framebuffer bars(const std::vector<Saving>& savings, int width, int height, int sheet_height) {
  studio::Canvas canvas(width, height, {width, height});
  canvas.letter_for(sheet_height);
  const double row = height / (double(savings.size()) + .5), left = .28 * width;
  for (std::size_t i = 0; i < savings.size(); ++i) {
    const double top = row * (double(i) + .4), words = top + .6 * row;
    const double right = left + .4 * width * std::log(savings[i].times) / std::log(100.0);
    canvas.words({left - .01 * width, words}, savings[i].name, ink::black, Align::right);
    canvas.rectangle({left, top}, {right + .001 * width, top + .7 * row}, ink::sky);
    canvas.words({right + .01 * width, words}, savings[i].words, ink::black);
  }
  return canvas.finish();
}

int main(int argc, char** argv) {
  studio::Lesson lesson("What each switch saves, and that no picture shows it.", 1800, 1240);
  int rows = 5;
  lesson.knob("--rows", rows, {1, 30}, "of things on each side of the viewer");

  return lesson.run(argc, argv, [&] {
    const Scene scene = make_crowd(rows);
    const Camera camera{.eye = {1.2, 2, 3}, .target = {-2.6, .1, -4.5}, .fov_deg = 36};
    Renderer renderer;
    const auto frame = [&](int width, int height, const SkipSwitch* off) {
      Frame drawn{Framebuffer(width, height, {.depth = true, .cost = true}), {}};
      RenderSettings settings;
      if (off) settings.skips.*off->member = false;
      drawn.stats = renderer.render(scene, camera, settings, drawn.picture);
      return drawn;
    };
    const studio::HeatScale scale = studio::count_scale(6);
    const int strip = lesson.height() / 8, top = lesson.height() * 39 / 100;
    std::vector<Saving> savings;
    Frame all_hidden;
    const auto draw = [&](int panel, int width, int height) {
      if (panel == 0) return studio::photograph(scene, camera, width, height);
      if (panel == 2) return scale.draw(all_hidden.depth_tests(), width, height);
      const Frame with = frame(width, height, nullptr);
      for (const SkipSwitch& skip : skip_switches()) {
        const Frame without = frame(width, height, &skip);
        savings.emplace_back(skip.name, with, without);
        if (skip.member == &Skips::hidden_clusters && with.stats.clusters_hidden == 0)
          savings.back().words = "nothing: there are no walls";
        lesson.figure("without " + savings.back().name, savings.back().words);
        if (skip.member == &Skips::hidden_triangles) all_hidden = without;
      }
      return scale.draw(with.depth_tests(), width, height);
    };
    const Framebuffer pictures =
        studio::panels(lesson.width(), top, 3,
                       {"the picture, each time", "depth tests", "without hidden-triangles"}, draw,
                       ink::slate, lesson.height());
    return studio::stacked(
        studio::stacked(pictures, scale.legend("depth tests at a pixel", lesson.width(), strip,
                                               lesson.height())),
        bars(savings, lesson.width(), lesson.height() - top - strip, lesson.height()));
  });
}
