// What the judge asks main.cpp. Nothing of this is yours.
#pragma once

namespace a7 {

enum Question { ask_choice = 1, ask_first, ask_second, ask_returned, ask_model, ask_picture };

}  // namespace a7
