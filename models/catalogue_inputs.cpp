#include "models/catalogue.h"
#include "models/checker.h"

namespace scanlit::models {

void link_input_catalogue() {}

}  // namespace scanlit::models
