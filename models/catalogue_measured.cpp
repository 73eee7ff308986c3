#include "models/catalogue.h"
#include "models/measured/merl.h"
#include "models/measured/utia.h"

namespace scanlit::models {

void link_measured_catalogue() {}

}  // namespace scanlit::models
