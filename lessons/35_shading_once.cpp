// New idea: first find out what each pixel sees, then shade it: once.
// Builds on: lesson 7, the depth buffer; lesson 12, shading at every fragment.
// Try: --balls 40; --balls 3000; how does the work grow, with the buffer and without?
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "lessons/studio/drawing/heat.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/tradeoff/by_hand.h"

using namespace scanlit;
namespace ink = studio::ink;

struct Ball {
  Vec3<double> centre;  // pixels; z towards the viewer, who is infinitely far away
  double radius;
  Rgb<double> colour;

  /// Of the ball's point that is seen at the centre of pixel (x, y); z is NaN beside the ball.
  Vec3<double> normal(int x, int y) const {
    const double nx = (x + .5 - centre.x) / radius, ny = (centre.y - y - .5) / radius;
    return {nx, ny, std::sqrt(1 - nx * nx - ny * ny)};
  }
};

/// Scan conversion and depth test: nearest(pixel) of each fragment that is the nearest so far.
template <class Nearest>
void for_each_nearest(const Ball& ball, Framebuffer& picture, const Nearest& nearest) {
  const auto& [c, r, colour] = ball;
  for (int y = std::max(0, int(c.y - r)); y < std::min(picture.height, int(c.y + r) + 1); ++y)
    for (int x = std::max(0, int(c.x - r)); x < std::min(picture.width, int(c.x + r) + 1); ++x) {
      const std::size_t pixel = std::size_t(y) * picture.width + x;
      const double depth = c.z + r * ball.normal(x, y).z;
      if (!(depth > picture.depth[pixel])) continue;
      picture.depth[pixel] = float(depth);
      nearest(pixel);
    }
}

void shade(const Ball& ball, std::size_t pixel, Framebuffer& picture) {
  const Vec3<double> n = ball.normal(int(pixel) % picture.width, int(pixel) / picture.width);
  const studio::ByHand reflect{.kd = ball.colour, .ks = .3, .n = 60};
  const Rgb<double> c = reflect(n, {-.5, .62, .604}, {0, 0, 1}) + ball.colour * .06;
  const double rgb[] = {c.r, c.g, c.b};
  std::copy(rgb, rgb + 3, &picture.colour[4 * pixel]);
  ++picture.cost[2 * pixel + 1];
}

// new idea
/// The depth buffer alone: whatever is the nearest so far is shaded. What comes later may hide it,
/// and then the work was for nothing.
void shade_at_once(const std::vector<Ball>& balls, Framebuffer& picture) {
  for (const Ball& ball : balls)
    for_each_nearest(ball, picture, [&](std::size_t pixel) { shade(ball, pixel, picture); });
}

/// With a visibility buffer, one word a pixel: the first pass keeps what is seen, the second shades
/// it.
void shade_once(const std::vector<Ball>& balls, Framebuffer& picture) {
  std::vector<const Ball*> seen(picture.pixel_count());
  for (const Ball& ball : balls)
    for_each_nearest(ball, picture, [&](std::size_t pixel) { seen[pixel] = &ball; });
  for (std::size_t pixel = 0; pixel < seen.size(); ++pixel)
    if (seen[pixel]) shade(*seen[pixel], pixel, picture);
}
// end of new idea

std::vector<Ball> make_balls(int count, int width, int height) {
  const Rgb<double> colours[] = {ink::blue, ink::sky, ink::orange, ink::vermilion, ink::paper};
  std::mt19937 random(7);
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i) {
    double u[4];
    for (double& each : u) each = double(random()) / 4294967296.0;
    balls.push_back({{u[0] * width, u[1] * height, (1 + u[2]) * height},
                     (.06 + .1 * u[3]) * height,
                     colours[random() % 5] * .75});
  }
  return balls;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Overdraw, and how a visibility buffer shades each pixel once.", 1800,
                        1240);
  int count = 320;
  lesson.knob("--balls", count, {1, 10000}, "how many");

  return lesson.run(argc, argv, [&] {
    const std::vector<std::string> names = {"the picture", "at once, back to front",
                                            "at once, in any order", "visibility buffer"};
    const studio::HeatScale scale = studio::count_scale(7);
    const int strip = lesson.height() / 8, n = 2;
    const auto draw = [&](int panel, int width, int height) {
      std::vector<Ball> balls = make_balls(count, n * width, n * height);
      if (panel == 1) std::ranges::sort(balls, {}, [](const Ball& b) { return b.centre.z; });
      Framebuffer picture(n * width, n * height, {.depth = true, .cost = true});
      (panel % 3 == 0 ? shade_once : shade_at_once)(balls, picture);
      if (panel == 0) return studio::reduced(picture, n);
      std::vector<double> shaded;
      for (std::size_t i = 1; i < picture.cost.size(); i += 2) shaded.push_back(picture.cost[i]);
      const double sum = std::accumulate(shaded.begin(), shaded.end(), 0.0);
      const auto uncovered = std::ranges::count(shaded, 0);
      lesson.figure(names[panel] + ", times a covered pixel is shaded",
                    studio::fixed(sum / double(shaded.size() - uncovered), 2));
      return studio::reduced(scale.draw(shaded, picture.width, picture.height), n);
    };
    return studio::stacked(
        studio::panels(lesson.width(), lesson.height() - strip, 2, names, draw, ink::slate,
                       lesson.height()),
        scale.legend("times a pixel is shaded", lesson.width(), strip, lesson.height()));
  });
}
