// New idea: a pixel is not a little square but one number: the light at the pixel's centre.
// Builds on: nothing.
// Try: --pixels 8; --pixels 100; from how far away is the coarse ball as good as the fine one?
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;

// new idea
/// What there is to see: a lit ball of radius .9, at every point (x, y) of [-1, 1] x [-1, 1].
Rgb<double> light_at(double x, double y) {
  const double z2 = 0.81 - x * x - y * y;
  if (z2 <= 0) return studio::ink::slate;                                // beside the ball
  const double n_l = (-0.5 * x + 0.6 * y + 0.62 * std::sqrt(z2)) / 0.9;  // N.L of the ball
  return Rgb<double>(.05, .10, .16) + Rgb<double>(.85, .45, .12) * std::max(n_l, 0.0);
}

/// An image: n x n numbers for each of red, green and blue. Returns how many pixels hit the ball.
int sample(Framebuffer& image) {
  int hits = 0;
  for (int j = 0; j < image.height; ++j)
    for (int i = 0; i < image.width; ++i) {
      const double x = 2 * (i + 0.5) / image.width - 1;   // the centre of pixel (i, j);
      const double y = 1 - 2 * (j + 0.5) / image.height;  // row 0 is on top
      const Rgb<double> light = light_at(x, y);
      float* pixel = &image.colour[4 * (std::size_t(j) * image.width + i)];
      pixel[0] = float(light.r), pixel[1] = float(light.g), pixel[2] = float(light.b);
      pixel[3] = 1;
      hits += x * x + y * y < 0.81;
    }
  return hits;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("A pixel is one number, the light at its centre.", 1560, 600);
  int coarse = 16;
  lesson.knob("--pixels", coarse, {1, 64}, "on each side of the coarse image");
  return lesson.run(argc, argv, [&] {
    const std::vector<int> sizes = {coarse, 4 * coarse, 16 * coarse};
    std::vector<std::string> captions;
    for (const int n : sizes) captions.push_back(std::to_string(n) + " x " + std::to_string(n));
    const auto draw = [&](int panel, int width, int height) {
      const int n = sizes[std::size_t(panel)];
      Framebuffer image(n, n);
      const double disc = 4.0 * sample(image) / (n * n);  // the ball's share of the square, area 4
      lesson.figure("pi, counted with " + captions[std::size_t(panel)] + " pixels",
                    studio::fixed(disc / 0.81, 4));
      studio::Canvas canvas(width, height, {n, n}, studio::ink::slate);
      canvas.image(image);
      if (panel == 0)
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i) canvas.dot({i + 0.5, j + 0.5}, studio::ink::grid, 3);
      return canvas.finish();
    };
    return studio::panels(lesson.width(), lesson.height(), 3, captions, draw);
  });
}
