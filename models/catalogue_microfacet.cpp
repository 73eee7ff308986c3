#include "models/catalogue.h"
#include "models/cook_torrance.h"
#include "models/torrance_sparrow.h"

namespace scanlit::models {

void link_microfacet_catalogue() {}

}  // namespace scanlit::models
