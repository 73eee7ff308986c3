// The models that every program has: each catalogue*.cpp includes some models' files, which is what
// registers them. They are several only so that they compile side by side.
#pragma once

namespace scanlit::models {

// Called so that the linker keeps the files.
void link_catalogue();
void link_classics_catalogue();
void link_composition_catalogue();
void link_microfacet_catalogue();
void link_measured_catalogue();
void link_wood_catalogue();
void link_input_catalogue();

}  // namespace scanlit::models
