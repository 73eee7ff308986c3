// What the judge asks main.cpp, and how both write it down. Nothing of this is yours.
#pragma once

#include "scan_conversion.h"

namespace a1 {

enum Question { ask_edge = 1, ask_owns, ask_covers, ask_span, ask_scan_convert };

template <class Numbers>
void put(Point p, Numbers& to) {
  to.integers.insert(to.integers.end(), {p.x, p.y});
}
template <class Numbers>
void put(const Triangle& t, Numbers& to) {
  for (const Point& p : t.corners) put(p, to);
}
template <class Numbers>
void put(const Edge& e, Numbers& to) {
  to.integers.insert(to.integers.end(), {e.a, e.b, e.c, e.owned});
}
template <class Numbers>
void put(const Edge (&edges)[3], Numbers& to) {
  for (const Edge& e : edges) put(e, to);
}

}  // namespace a1
