// A renderer as textbooks have it: one triangle, one pixel, one light after the other, in scalar
// float or double, on one thread. What the engine's vectors are compared with, and where variants
// are tried that the engine does not offer. Visibility comes first, as in the engine, so that the
// times differ by arithmetic alone.
//
// Phong shading with one sample a pixel, lights without a cone, colour form 1. Nothing may reach
// behind the eye: there is no clipping.
#pragma once

#include <cmath>
#include <vector>

#include "rasterizer/draw.h"
#include "rasterizer/reference/reference.h"
#include "rasterizer/reference/surface_light.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit::studio {

struct TextbookOptions {
  int perspective_every = 1;  // pixels from one division by w to the next, linear between; 0: none
  bool normalise = true;      // the interpolated normal
};

template <class T>
Vec3<T> normalised(const Vec3<T>& v) {
  return v * (T(1) / std::sqrt(dot(v, v)));
}

template <class T, class V>
Vec3<T> vec3(const V& v) {
  return {T(v.x), T(v.y), T(v.z)};
}

/// `Reflect` is called as reflect(n, l, v) and gives pi f_r (n.l), Rgb<T>, of directions that are
/// unit (but for n, where it is not normalised).
template <class T, class Reflect>
class Textbook {
 public:
  Textbook(const Scene& scene, const Camera& camera, const TextbookOptions& options,
           const Reflect& reflect)
      : scene_(scene), camera_(camera), options_(options), reflect_(reflect) {}

  /// Into pixels of any size, which are kept from frame to frame.
  void draw(int width, int height, std::vector<Rgb<T>>& colour) {
    viewport_ = {width, height};
    const std::size_t count = std::size_t(width) * std::size_t(height);
    depth_.assign(count, 0.0f);
    seen_.assign(count, nullptr);
    colour.assign(count, scene_.background * T(1));
    const auto seen_from = [&](int x, int y) { return pixel_to_eye(camera_, width, height, x, y); };
    const glm::dvec3 first = seen_from(0, 0);
    first_ = vec3<T>(first);
    right_ = vec3<T>(seen_from(1, 0) - first), below_ = vec3<T>(seen_from(0, 1) - first);
    triangles_.clear();
    for (const Object& object : scene_.objects) set_up(object);
    for (const Triangle& t : triangles_) scan_convert(t);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width;) {
        const Triangle* const t = seen_[index(x, y)];
        const int begin = x;
        while (x < width && seen_[index(x, y)] == t) ++x;
        if (t) shade(*t, begin, x, y, &colour[index(begin, y)]);
      }
  }

 private:
  struct Vertex {
    Vec3<T> position, normal;  // world space
    ScreenVertex screen;
    T inv_w;
  };
  struct Triangle {
    ScreenTriangle screen;
    const Object* object;
    Vertex v[3];
  };

  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(viewport_.width) + std::size_t(x);
  }

  /// Vertices to world space and to the screen, and triangles of them.
  void set_up(const Object& object) {
    const Mesh& mesh = *object.mesh;
    const Draw draw = make_draw(object, 0, clip_from_world(camera_, aspect()), clusters_);
    const glm::mat<4, 4, T> world_from_object(object.world_from_object);
    const glm::mat<4, 4, T> clip_from_object(clip_from_world(camera_, aspect()) *
                                             glm::dmat4(object.world_from_object));
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const glm::vec<4, T> position(glm::vec<3, T>(mesh.positions[i]), T(1));
      const glm::vec<3, T> normal =
          glm::mat<3, 3, T>(draw.normal_from_object) * glm::vec<3, T>(mesh.normals[i]);
      vertices[i] = {vec3<T>(world_from_object * position), normalised(vec3<T>(normal)),
                     project(transform(draw, mesh.positions[i]), viewport_),
                     T(1) / (clip_from_object * position).w};
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      Triangle t{{}, &object, {}};
      for (std::size_t k = 0; k < 3; ++k) t.v[k] = vertices[mesh.indices[i + k]];
      t.screen = screen_triangle(t.v[0].screen, t.v[1].screen, t.v[2].screen);
      const bool behind = (t.screen.twice_area < 0) != draw.mirrored;
      if (t.screen.twice_area == 0 || (behind && !draw.draw_back_faces)) continue;
      if (behind)
        for (Vertex& v : t.v) v.normal = -v.normal;
      triangles_.push_back(t);
    }
  }

  double aspect() const { return double(viewport_.width) / viewport_.height; }

  void scan_convert(const Triangle& t) {
    const DepthPlane plane(t.screen);
    for_each_span(t.screen, 0, viewport_.height, [&](int y, int x_begin, int x_end) {
      x_begin = std::max(x_begin, 0), x_end = std::min(x_end, viewport_.width);
      if (x_begin >= x_end) return;
      float depth = plane.at(x_begin, y);
      const float step = plane.per_pixel();
      for (int x = x_begin; x < x_end; ++x, depth += step) {
        const std::size_t i = index(x, y);
        if (depth > depth_[i]) depth_[i] = depth, seen_[i] = &t;
      }
    });
  }

  /// Weights of corners 1 and 2.
  struct Weights {
    T b1, b2;
  };

  /// A run of one triangle's pixels.
  void shade(const Triangle& t, int begin, int end, int y, Rgb<T>* colour) const {
    const auto& [a, b, c] = t.screen.vertices;
    const std::int64_t px = std::int64_t(begin) * subpixel + half_pixel;
    const std::int64_t py = std::int64_t(y) * subpixel + half_pixel;
    const T scale = T(1) / T(t.screen.twice_area);
    const T first_1 = T(edge_function(c, a, px, py)) * scale;
    const T first_2 = T(edge_function(a, b, px, py)) * scale;
    const T step_1 = T(a.y - c.y) * T(subpixel) * scale,
            step_2 = T(b.y - a.y) * T(subpixel) * scale;
    const auto linear = [&](int x) {
      return Weights{first_1 + T(x - begin) * step_1, first_2 + T(x - begin) * step_2};
    };
    const auto exact = [&](int x) {
      const Weights l = linear(x);
      const T w0 = (T(1) - l.b1 - l.b2) * t.v[0].inv_w;
      const T w1 = l.b1 * t.v[1].inv_w, w2 = l.b2 * t.v[2].inv_w, w = T(1) / (w0 + w1 + w2);
      return Weights{w1 * w, w2 * w};
    };
    const int every = options_.perspective_every;
    if (every <= 1) {
      for (int x = begin; x < end; ++x) *colour++ = lit(t, every ? exact(x) : linear(x), x, y);
      return;
    }
    for (int from = begin; from < end; from += every) {
      const int to = std::min(from + every, end);  // linear up to the next division
      const Weights at_from = exact(from), at_to = exact(to);
      const T share = T(1) / T(to - from);
      const Weights step{(at_to.b1 - at_from.b1) * share, (at_to.b2 - at_from.b2) * share};
      for (int x = from; x < to; ++x)
        *colour++ =
            lit(t, {at_from.b1 + T(x - from) * step.b1, at_from.b2 + T(x - from) * step.b2}, x, y);
    }
  }

  Rgb<T> lit(const Triangle& t, const Weights& b, int x, int y) const {
    const auto at = [&](Vec3<T> Vertex::*attribute) {
      const Vec3<T>& first = t.v[0].*attribute;
      return first + b.b1 * (t.v[1].*attribute - first) + b.b2 * (t.v[2].*attribute - first);
    };
    const Vec3<T> position = at(&Vertex::position), interpolated = at(&Vertex::normal);
    const Vec3<T> n = options_.normalise ? normalised(interpolated) : interpolated;
    const Vec3<T> v = normalised(first_ + T(x) * right_ + T(y) * below_);
    Rgb<T> sum = t.object->material.ka * (scene_.ambient * T(1));
    for (const Light& light : scene_.lights) {
      Vec3<T> l = vec3<T>(light.direction);
      T share(light.intensity);
      if (light.kind != LightKind::directional) {
        l = vec3<T>(light.position) - position;
        const T d2 = dot(l, l);
        share =
            share / (T(light.constant) + T(light.linear) * std::sqrt(d2) + T(light.quadratic) * d2);
      }
      sum = sum + (light.colour * share) * reflect_(n, normalised(l), v);
    }
    return sum;
  }

  const Scene& scene_;
  const Camera& camera_;
  TextbookOptions options_;
  const Reflect& reflect_;
  ClusterCache clusters_;
  Viewport viewport_;
  Vec3<T> first_, right_, below_;  // V of pixel (x, y): first + x right + y below, not unit
  std::vector<Triangle> triangles_;
  std::vector<float> depth_;
  std::vector<const Triangle*> seen_;
};

}  // namespace scanlit::studio
