#include "models/catalogue.h"
#include "models/clear_coat.h"
#include "models/materials.h"
#include "models/sum.h"

namespace scanlit::models {

void link_composition_catalogue() {}

}  // namespace scanlit::models
