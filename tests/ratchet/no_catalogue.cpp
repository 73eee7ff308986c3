// The catalogue of programs that are to be built in seconds: the models that they include.
#include "models/catalogue.h"

void scanlit::models::link_catalogue() {}
