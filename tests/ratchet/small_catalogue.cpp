// The catalogue of programs that are to be built in seconds: what their tests ask for by name.
#include "models/blinn_phong.h"
#include "models/catalogue.h"
#include "models/inputs/noise.h"
#include "models/phong.h"

void scanlit::models::link_catalogue() {}
