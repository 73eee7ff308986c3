// What the judge asks main.cpp. Nothing of this is yours.
#pragma once

namespace a3 {

enum Question {
  ask_depth_of = 1,
  ask_depth_at,
  ask_stored,
  ask_farthest,
  ask_replaces,
  ask_draw,
  ask_depth_span,
  ask_test_span
};

}  // namespace a3
