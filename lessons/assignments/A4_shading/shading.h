// A4, Gouraud and Phong shading: what is yours to write, in shading.cpp. README.md says what each
// function is to do.
#pragma once

#include <cmath>
#include <vector>

namespace a4 {

/// A position or a direction in world space, or a colour: linear light, red, green and blue.
struct Vector {
  double x, y, z;
};
using Colour = Vector;

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(Vector a, Vector b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// Of a vector that is not 0.
inline Vector unit(Vector a) { return (1 / std::sqrt(dot(a, a))) * a; }

/// Infinitely far away.
struct Light {
  Vector to_light;  // unit
  Colour colour;    // intensity included
};

struct Scene {
  Vector eye;
  std::vector<Light> lights;
  Colour ambient;  // Ka Ia, of the surface and the light together
  Colour kd;       // diffuse reflectance
  double ks, n;    // the highlight: how strong, how sharp
};

struct Vertex {
  Vector position;
  Vector normal;  // of any length but 0
};

/// Shares of the three corners, which add up to 1.
struct Weights {
  double corner[3];
};

/// The functions below, for the later ones to call. While a part is judged, these are right,
/// whatever yours are; in the pictures of A4.6 they are your own.
struct Stages {
  Colour (*light)(Vector normal, Vector to_viewer, const Scene& scene);
  Vector (*interpolate)(const Vector (&corners)[3], const Weights& weights);
  Vector (*interpolate_normal)(const Vector (&normals)[3], const Weights& weights);
};

/// A4.1
Colour light(Vector normal, Vector to_viewer, const Scene& scene);
/// A4.2
Colour shade_vertex(const Vertex& vertex, const Scene& scene, const Stages& stages);
/// A4.3
Vector interpolate(const Vector (&corners)[3], const Weights& weights);
/// A4.4
Vector interpolate_normal(const Vector (&normals)[3], const Weights& weights);
/// A4.5
Colour shade_fragment(const Vertex (&triangle)[3], const Weights& weights, const Scene& scene,
                      const Stages& stages);

}  // namespace a4
