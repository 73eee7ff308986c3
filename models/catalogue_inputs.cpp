#include "models/catalogue.h"
#include "models/inputs/checker.h"
#include "models/inputs/image.h"

namespace scanlit::models {

void link_input_catalogue() {}

}  // namespace scanlit::models
