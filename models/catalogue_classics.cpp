#include "models/ashikhmin_shirley.h"
#include "models/catalogue.h"
#include "models/lafortune.h"
#include "models/oren_nayar.h"
#include "models/oren_nayar_full.h"
#include "models/ward.h"

namespace scanlit::models {

void link_classics_catalogue() {}

}  // namespace scanlit::models
