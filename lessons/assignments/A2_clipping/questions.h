// What the judge asks main.cpp, and how both write it down. Nothing of this is yours.
#pragma once

#include "clipping.h"

namespace a2 {

enum Question {
  ask_distance = 1,
  ask_cut,
  ask_clip,
  ask_triangle,
  ask_perspective,
  ask_whole_triangle,
  ask_perspective_span
};

template <class Numbers>
void put(const Vertex& v, Numbers& to) {
  to.reals.insert(to.reals.end(), {v.x, v.y, v.z, v.w});
  to.reals.insert(to.reals.end(), v.attribute, v.attribute + 3);
}
template <class Numbers>
void put(const Polygon& polygon, Numbers& to) {
  for (const Vertex& v : polygon) put(v, to);
}
template <class Numbers>
void put(const Weights& w, Numbers& to) {
  to.reals.insert(to.reals.end(), w.corner, w.corner + 3);
}

}  // namespace a2
