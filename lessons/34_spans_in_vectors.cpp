// New idea: one formula, evaluated for a whole vector of pixels at a time.
// Builds on: lesson 12, Phong shading; lesson 4, spans.
// Try: --lanes 16; --n 32; what happens to vectors when triangles are as small as pixels?
#include <algorithm>
#include <chrono>
#include <cmath>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "rasterizer/batch_vec.h"
#include "rasterizer/scalar_math.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// Kd (N.L) + Ks (N.H)^n, light and viewer far away. T is float, one pixel, or Batch, a vector of
/// them: + and * then add and multiply all lanes with one instruction.
template <class T>
Rgb<T> shade(const Vec3<T>& n) {
  const Vec3<T> l{T(-.514), T(.600), T(.613)}, h{T(-.286), T(.334), T(.898)};
  const T n_l = max(dot(n, l), T(0)), n_h = max(dot(n, h), T(1e-4));
  return Rgb<double>(.05, .16, .22) * (n_l + T(.1)) + Rgb<double>(.6) * exp(T(60) * log(n_h));
}

/// All x stand beside each other, then all y, all z: so a vector is loaded at once. The arrays end
/// with whole vectors.
struct Points {
  std::vector<float> n[3], colour[3];
};

void one_by_one(Points& p, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const Rgb<float> c = shade(Vec3<float>{p.n[0][i], p.n[1][i], p.n[2][i]});
    p.colour[0][i] = c.r, p.colour[1][i] = c.g, p.colour[2][i] = c.b;
  }
}

void in_vectors(Points& p, std::size_t size) {
  for (std::size_t i = 0; i < size; i += Batch::lanes) {
    const Rgb<Batch> c = shade(
        Vec3<Batch>{Batch::load(&p.n[0][i]), Batch::load(&p.n[1][i]), Batch::load(&p.n[2][i])});
    c.r.store(&p.colour[0][i]), c.g.store(&p.colour[1][i]), c.b.store(&p.colour[2][i]);
  }
}
// end of new idea

/// How many pixels each vector holds, if a run of pixels of one triangle begins a new one, or if
/// all runs are gathered first.
std::vector<int> filled_lanes(const Framebuffer& ids, int lanes, bool gathered) {
  std::vector<int> vectors;
  std::uint32_t last = no_id;
  for (std::size_t i = 0; i < ids.pixel_count(); ++i) {
    const std::uint32_t id = i % ids.width == 0 && !gathered ? no_id : last;
    last = ids.triangle_id[i];
    if (last == no_id) continue;
    const bool new_run = !gathered && id != last;
    if (vectors.empty() || vectors.back() == lanes || new_run) vectors.push_back(0);
    ++vectors.back();
  }
  return vectors;
}

Framebuffer lanes_picture(const std::vector<int>& vectors, int lanes, int width, int height) {
  const int across = 72 / (lanes + 1), rows = 40;
  studio::Canvas canvas(width, height, {across * (lanes + 1.0) - 1, double(rows)}, ink::slate);
  for (int i = 0; i < std::min(int(vectors.size()), across * rows); ++i)
    for (int lane = 0; lane < lanes; ++lane) {
      const glm::dvec2 at(i % across * (lanes + 1) + lane, i / across);
      canvas.rectangle(at + .06, at + .94, lane < vectors[i] ? ink::sky : ink::vermilion * .6);
    }
  return canvas.finish();
}

/// The fastest of several times: what disturbs only ever makes it slower.
template <class Work>
double milliseconds(const Work& work) {
  double least = 1e9;
  for (int i = 0; i < 20; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    least = std::min(least, took.count());
  }
  return least;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("The same picture, pixel by pixel and in vectors.", 1800, 1100);
  int lanes = 8, n = 4;
  lesson.knob("--lanes", lanes, {2, 64}, "of the vectors that are drawn");
  lesson.knob("--n", n, {2, 64}, "segments a side of each of the teapot's patches");

  return lesson.run(argc, argv, [&] {
    const std::vector<std::string> names = {"pixel by pixel", "in vectors", "lanes, run by run",
                                            "lanes, gathered"};
    Points points;
    const auto draw = [&](int panel, int width, int height) {
      const Scene scene =
          studio::make_stage({studio::make_object("teapot:" + std::to_string(n), "lambert")});
      const Camera camera =
          studio::fitted({.eye = {1, 2, 5}, .fov_deg = 20}, scene, double(width) / height);
      const int scale = panel < 2 ? 1 : 14;
      Framebuffer picture((width + scale - 1) / scale, (height + scale - 1) / scale,
                          {.normal = true, .ids = true});
      render(scene, camera, {}, picture);
      if (panel > 1) {
        const auto vectors = filled_lanes(picture, lanes, panel == 3);
        double pixels = 0;
        for (int each : vectors) pixels += each;
        lesson.figure(names[panel] + ", at work",
                      studio::fixed(100 * pixels / (double(lanes) * vectors.size()), 0) + " % of " +
                          std::to_string(vectors.size()) + " vectors");
        return lanes_picture(vectors, lanes, width, height);
      }
      const std::size_t size = picture.pixel_count();
      for (int k = 0; k < 3; ++k) {
        points.n[k].assign(size + max_lanes, 0), points.colour[k].resize(size + max_lanes);
        for (std::size_t i = 0; i < size; ++i) points.n[k][i] = picture.normal[3 * i + k];
      }
      lesson.time(names[panel],
                  milliseconds([&] { (panel ? in_vectors : one_by_one)(points, size); }));
      for (std::size_t i = 0; i < size; ++i)
        for (int k = 0; k < 3; ++k)
          if (picture.triangle_id[i] != no_id) picture.colour[4 * i + k] = points.colour[k][i];
      return picture;
    };
    return studio::panels(lesson.width(), lesson.height(), 2, names, draw);
  });
}
