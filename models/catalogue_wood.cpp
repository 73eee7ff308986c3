#include "models/catalogue.h"
#include "models/finished_wood.h"

namespace scanlit::models {

void link_wood_catalogue() {}

}  // namespace scanlit::models
