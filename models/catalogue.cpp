// A new model is one file and one line here.
#include "models/catalogue.h"

#include "models/blinn_phong.h"
#include "models/lambert.h"
#include "models/phong.h"

namespace scanlit::models {

void link_catalogue() {
  link_classics_catalogue();
  link_composition_catalogue();
  link_microfacet_catalogue();
  link_measured_catalogue();
  link_wood_catalogue();
  link_input_catalogue();
}

}  // namespace scanlit::models
