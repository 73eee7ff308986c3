// Round numbers for axes.
#pragma once

#include <string>
#include <vector>

namespace scanlit::studio {

/// 0, step, 2 step, ... up to the first that is at least `max`, with a step of 1, 2 or 5 times a
/// power of ten and about `count` of them. For max > 0.
std::vector<double> round_ticks(double max, int count);

/// "0.25", "20", "5e-05": as short as tells the ticks apart.
std::string tick_text(double value);

/// "10" and the exponent as superscript characters.
std::string power_of_ten(int exponent);

}  // namespace scanlit::studio
