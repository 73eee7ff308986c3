// What the judge asks main.cpp, and how both write it down. Nothing of this is yours.
#pragma once

#include "shading.h"

namespace a4 {

enum Question {
  ask_light = 1,
  ask_vertex,
  ask_interpolate,
  ask_normal,
  ask_fragment,
  ask_gouraud_span,
  ask_phong_span
};

template <class Numbers>
void put(Vector v, Numbers& to) {
  to.reals.insert(to.reals.end(), {v.x, v.y, v.z});
}
template <class Numbers>
void put(const Vertex& v, Numbers& to) {
  put(v.position, to), put(v.normal, to);
}
template <class Numbers>
void put(const Weights& w, Numbers& to) {
  to.reals.insert(to.reals.end(), w.corner, w.corner + 3);
}
template <class Numbers>
void put(const Scene& s, Numbers& to) {
  put(s.eye, to), put(s.ambient, to), put(s.kd, to);
  to.reals.insert(to.reals.end(), {s.ks, s.n});
  to.integers.push_back(std::int64_t(s.lights.size()));
  for (const Light& each : s.lights) put(each.to_light, to), put(each.colour, to);
}

}  // namespace a4
