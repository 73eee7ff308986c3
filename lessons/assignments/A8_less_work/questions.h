// What the judge asks main.cpp, and what it asks back. Nothing of this is yours.
#pragma once

namespace a8 {

enum Question { ask_shade = 1, ask_evaluate };

}  // namespace a8
