#include "models/catalogue.h"
#include "models/inputs/checker.h"
#include "models/inputs/image.h"
#include "models/inputs/noise.h"
#include "models/inputs/vertex_colour.h"
#include "models/inputs/wood.h"

namespace scanlit::models {

void link_input_catalogue() {}

}  // namespace scanlit::models
