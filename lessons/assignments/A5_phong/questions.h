// What the judge asks main.cpp. Nothing of this is yours.
#pragma once

namespace a5 {

enum Question {
  ask_phong_exponent = 1,
  ask_blinn_exponent,
  ask_half_vector,
  ask_mirrored,
  ask_diffuse,
  ask_phong,
  ask_blinn,
  ask_tinted,
  ask_plastic,
  ask_tinted_picture,
  ask_plastic_picture
};

}  // namespace a5
