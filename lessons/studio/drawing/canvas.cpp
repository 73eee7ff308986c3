#include "lessons/studio/drawing/canvas.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>

#include "lessons/studio/program.h"
#include "lessons/studio/reflect/sheet_layout.h"
#include "models/registry.h"
#include "rasterizer/render.h"

namespace scanlit::studio {
namespace {

constexpr float layer = 1e-3f;  // between shapes, in pixels: who is drawn later is nearer

/// One white light along the view, so that kd is the colour that is seen.
Scene lit_head_on(std::shared_ptr<const Mesh> mesh) {
  Object object;
  object.mesh = std::move(mesh);
  object.material.model = models::make("lambert:kd=vertex-colour").model;
  object.material.ka = Rgb<double>(0);
  Scene scene;
  scene.objects = {object};
  scene.lights = {Light{}};
  return scene;
}

/// World space is the picture's pixels, with y up.
Camera over_the_picture(int width, int height, float nearest) {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.height = height;
  camera.target = {width / 2.0, -height / 2.0, 0};
  camera.eye = camera.target + glm::dvec3(0, 0, nearest + 2);
  camera.near = 1;
  camera.far = nearest + 3;
  return camera;
}

}  // namespace

WordSizes word_sizes(int picture_height) {
  return {std::max(9, picture_height / 27), std::max(8, (picture_height + 39) / 40)};
}

void write_words(Framebuffer& picture, double x, double y, const std::string& words, Align align,
                 const Rgb<double>& colour, double max_width, const WordSizes& sizes) {
  static const auto font = label_font();
  if (!font || words.empty()) return;
  int size = sizes.largest;
  while (size > sizes.smallest && font->width(words, size) > max_width) --size;
  const double width = font->width(words, size);
  const double left = align == Align::left ? x : align == Align::centre ? x - width / 2 : x - width;
  if (width > max_width || left < 0 || left + width > picture.width || y > picture.height ||
      y - size < 0)
    return warn("the picture is too small for these words: " + words);
  const Rgb<float> ink(float(colour.r), float(colour.g), float(colour.b));
  font->draw(picture, int(std::lround(x)), int(std::lround(y)), words, size, align, ink);
}

Canvas::Canvas(Framebuffer picture)
    : picture_(std::move(picture)), word_sizes_(word_sizes(picture_.height)) {}

Canvas::Canvas(int width, int height, glm::dvec2 window, const Rgb<double>& paper)
    : picture_(blank_picture(width, height, paper)),
      word_sizes_(word_sizes(height)),
      scale_(std::min(width / window.x, height / window.y)) {
  origin_ = (glm::dvec2(width, height) - scale_ * window) / 2.0;
}

void Canvas::image(const Framebuffer& image) {
  constexpr int samples = 4;  // a side: squares need not begin where the picture's pixels do
  const auto sum = [&](int x, int y, float* pixel) {
    for (int s = 0; s < samples * samples; ++s) {
      const glm::dvec2 within(s % samples + 0.5, s / samples + 0.5);
      const glm::ivec2 at =
          glm::floor((glm::dvec2(x, y) + within / double(samples) - origin_) / scale_);
      if (at.x < 0 || at.y < 0 || at.x >= image.width || at.y >= image.height) return false;
      for (std::size_t c = 0; c < 4; ++c)
        pixel[c] += image.colour[4 * (std::size_t(at.y) * image.width + at.x) + c];
    }
    return true;
  };
  for (int y = 0; y < picture_.height; ++y)
    for (int x = 0; x < picture_.width; ++x)
      if (float pixel[4] = {}; sum(x, y, pixel))
        for (std::size_t c = 0; c < 4; ++c)
          picture_.colour[4 * (std::size_t(y) * picture_.width + x) + c] =
              pixel[c] / (samples * samples);
}

void Canvas::fan(const std::vector<glm::dvec2>& pixels, const Rgb<double>& colour) {
  const auto first = std::uint32_t(shapes_.positions.size());
  const glm::dvec2 u = pixels[1] - pixels[0], v = pixels[2] - pixels[0];
  const bool front_face = u.x * v.y < u.y * v.x;  // counter-clockwise, with y down
  const float z = float(shapes_.indices.size()) * layer;
  for (const glm::dvec2& p : pixels) {
    shapes_.positions.emplace_back(float(p.x), float(-p.y), z);
    shapes_.normals.emplace_back(0, 0, 1);
    shapes_.colours.emplace_back(float(colour.r), float(colour.g), float(colour.b));
  }
  for (std::uint32_t i = 2; i < pixels.size(); ++i)
    shapes_.indices.insert(shapes_.indices.end(), {first, front_face ? first + i - 1 : first + i,
                                                   front_face ? first + i : first + i - 1});
}

void Canvas::polygon(const std::vector<glm::dvec2>& convex, const Rgb<double>& colour) {
  std::vector<glm::dvec2> pixels;
  for (const glm::dvec2& point : convex) pixels.push_back(pixel(point));
  fan(pixels, colour);
}

void Canvas::rectangle(glm::dvec2 low, glm::dvec2 high, const Rgb<double>& colour) {
  polygon({low, {high.x, low.y}, high, {low.x, high.y}}, colour);
}

void Canvas::cell(int i, int j, const Rgb<double>& colour) {
  rectangle({i, j}, {i + 1, j + 1}, colour);
}

void Canvas::grid(int columns, int rows, const Rgb<double>& colour, double width) {
  for (int i = 0; i <= columns; ++i) line({i, 0}, {i, rows}, colour, width);
  for (int j = 0; j <= rows; ++j) line({0, j}, {columns, j}, colour, width);
}

void Canvas::stroke(glm::dvec2 a, glm::dvec2 b, const Rgb<double>& colour, double width) {
  if (a == b) return;
  const glm::dvec2 along = glm::normalize(b - a) * (thickness(width) / 2);
  const glm::dvec2 across(-along.y, along.x);
  fan({a + across, b + across, b - across, a - across}, colour);
}

void Canvas::line(glm::dvec2 a, glm::dvec2 b, const Rgb<double>& colour, double width) {
  stroke(pixel(a), pixel(b), colour, width);
}

void Canvas::polyline(const std::vector<glm::dvec2>& points, const Rgb<double>& colour,
                      double width) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    dot(points[i], colour, width / 2);  // rounds the joint
    if (i > 0) line(points[i - 1], points[i], colour, width);
  }
}

void Canvas::outline(std::vector<glm::dvec2> points, const Rgb<double>& colour, double width) {
  points.push_back(points.front());
  polyline(points, colour, width);
}

void Canvas::arrow(glm::dvec2 from, glm::dvec2 to, const Rgb<double>& colour, double width) {
  const glm::dvec2 a = pixel(from), b = pixel(to);
  const double head = 4 * thickness(width);
  const glm::dvec2 along = glm::normalize(b - a), across(-along.y, along.x);
  const glm::dvec2 neck = b - along * head;
  stroke(a, neck, colour, width);
  fan({b, neck + across * (head * .4), neck - across * (head * .4)}, colour);
}

void Canvas::dot(glm::dvec2 centre, const Rgb<double>& colour, double radius) {
  constexpr int corners = 24;
  std::vector<glm::dvec2> circle;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    circle.push_back(pixel(centre) +
                     thickness(radius) * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  fan(circle, colour);
}

void Canvas::words(glm::dvec2 at, const std::string& words, const Rgb<double>& colour,
                   Align align) {
  words_.push_back({pixel(at), words, colour, align});
}

Framebuffer Canvas::finish() {
  if (!shapes_.indices.empty()) {
    const float nearest = float(shapes_.indices.size()) * layer;
    RenderSettings settings;
    settings.samples = 16;
    Framebuffer drawn(picture_.width, picture_.height);
    render(lit_head_on(std::make_shared<const Mesh>(std::move(shapes_))),
           over_the_picture(picture_.width, picture_.height, nearest), settings, drawn);
    shapes_ = {};
    for (std::size_t i = 0; i < picture_.colour.size(); i += 4) {
      const float behind = 1 - drawn.colour[i + 3];
      for (std::size_t c = i; c < i + 4; ++c)
        picture_.colour[c] = drawn.colour[c] + behind * picture_.colour[c];
    }
  }
  for (const Words& each : words_)
    write_words(picture_, each.at.x, each.at.y, each.words, each.align, each.colour, picture_.width,
                word_sizes_);
  words_.clear();
  return std::move(picture_);
}

}  // namespace scanlit::studio
