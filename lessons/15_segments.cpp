// New idea: an error is a number: the difference to a picture that is right, over all pixels.
// Builds on: lesson 13, the three shadings.
// Try: --n 200; --n 5; how many segments does Gouraud need to be as good as Phong shading with 8?
#include <cmath>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;

// new idea
struct Deviation {
  double rms = 0;        // root of the mean square: large errors count more
  double brightest = 0;  // of the picture: what is left of the highlight
};

/// Where the object is in both pictures, so that its outline, which no shading changes, is left
/// out.
Deviation compare(const Framebuffer& picture, const Framebuffer& right) {
  Deviation error;
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < picture.colour.size(); i += 4) {
    if (picture.colour[i + 3] < 1 || right.colour[i + 3] < 1) continue;
    for (std::size_t c = i; c < i + 3; ++c) {
      const double difference = picture.colour[c] - right.colour[c];
      squares += difference * difference;
      error.brightest = std::max(error.brightest, double(picture.colour[c]));
      ++count;
    }
  }
  error.rms = std::sqrt(squares / count);
  return error;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("How many segments are enough?", 1500, 1060);
  double n = 120;
  lesson.knob("--n", n, {1, 1000}, "exponent of the highlight");

  return lesson.run(argc, argv, [&] {
    const std::string model = "blinn-phong:kd=.42/.10/.14,ks=.45,n=" + studio::text_of(n);
    const auto sphere = [&](int segments, Shading shading, int width, int height) {
      Object object = studio::make_object("sphere:" + std::to_string(segments), model, shading);
      Camera camera;
      camera.eye = {0, .9, 5};
      camera.projection = Projection::orthographic;
      camera.height = 2.1;
      camera.far = 10;
      Framebuffer picture = studio::photograph(studio::make_stage({object}), camera, width, height);
      return picture;
    };
    std::vector<std::string> captions;
    for (const char* shading : {"Gouraud, ", "Phong shading, "})
      for (const char* segments : {"8 segments", "32", "128"})
        captions.push_back(std::string(shading) + segments);
    Framebuffer right;
    const auto draw = [&](int panel, int width, int height) {
      const int segments[] = {8, 32, 128};
      const Shading shading = panel < 3 ? Shading::gouraud : Shading::phong;
      Framebuffer picture = sphere(segments[panel % 3], shading, width, height);
      if (panel == 0) right = sphere(256, Shading::phong, width, height);
      const Deviation error = compare(picture, right);
      lesson.figure(captions[std::size_t(panel)], "error " + studio::fixed(100 * error.rms, 2) +
                                                      " % of white, brightest " +
                                                      studio::fixed(error.brightest, 2));
      return picture;
    };
    return studio::panels(lesson.width(), lesson.height(), 3, captions, draw);
  });
}
