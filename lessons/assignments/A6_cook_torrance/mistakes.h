// The mistakes that are made most with D, G, F and their product, as formulas.
#pragma once

#include <vector>

#include "lessons/assignments/A6_cook_torrance/reference.h"

namespace scanlit::assignments::cook_torrance {

std::vector<Mistake> mistakes_of_D(const Variant& variant);
std::vector<Mistake> mistakes_of_G(const Variant& variant);
std::vector<Mistake> mistakes_of_F(const Variant& variant);
std::vector<Mistake> mistakes_of_product(const Variant& variant);

}  // namespace scanlit::assignments::cook_torrance
