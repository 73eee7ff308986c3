#include "models/catalogue.h"

namespace scanlit::models {

void link_microfacet_catalogue() {}

}  // namespace scanlit::models
