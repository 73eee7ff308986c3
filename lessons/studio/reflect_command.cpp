// scanlit reflect
#include <algorithm>
#include <memory>

#include "lessons/studio/commands.h"
#include "lessons/studio/reflect/actions.h"
#include "rasterizer/error.h"

namespace scanlit::studio {

bool ReflectOptions::given(const std::string& option) const { return app->count(option) > 0; }

namespace {

struct Action {
  const char* option;
  void (*run)(const ReflectOptions& options);
  std::vector<std::string> goes_with;  // options that mean something to it
};

const std::vector<Action>& actions() {
  static const std::vector<Action> all{
      {"--values", print_values, {"--precision"}},
      {"--plot", plot, {"--angles", "--azimuth", "--quantity", "--log", "--cell", "--exposure"}},
      {"--terms", print_terms, {"--angles", "--azimuth"}},
      {"--furnace", print_furnace, {"--angles", "--azimuth"}},
      {"--reciprocity", print_reciprocity, {}},
      {"--tabulate", write_table, {}},
  };
  return all;
}

/// The one action that was asked for. Throws Error: none, several, an option of another.
const Action& chosen_action(const ReflectOptions& options) {
  const Action* chosen = nullptr;
  std::string names;
  for (const Action& action : actions()) {
    names += (names.empty() ? "" : ", ") + std::string(action.option);
    if (!options.given(action.option)) continue;
    if (chosen)
      throw Error(action.option, std::string("does not go together with ") + chosen->option);
    chosen = &action;
  }
  if (!chosen) throw Error("reflect wants to be told what to do; one of " + names);
  for (const Action& action : actions())
    for (const std::string& option : action.goes_with)
      if (options.given(option) &&
          std::ranges::find(chosen->goes_with, option) == chosen->goes_with.end())
        throw Error(option, std::string("has no meaning to ") + chosen->option);
  return *chosen;
}

void add_options(CLI::App& app, ReflectOptions& o) {
  app.add_option("MODEL", o.models,
                 "reflection models, see scanlit models; a plot may have several")
      ->type_name("")
      ->required();
  app.add_option("-o,--output", o.output, "file to be written; text otherwise goes to the terminal")
      ->type_name("FILE");
  const char* const what = "What to do (one of these)";
  app.add_option("--values", o.rows, "the values of pi f_r (n.l) for rows lx,ly,lz,vx,vy,vz (-)")
      ->type_name("[FILE]")
      ->expected(0, 1)
      ->group(what);
  app.add_option("--plot", o.plot,
                 "polar, cartesian, albedo, spectrum (.svg); sphere, slice (a picture)")
      ->type_name("KIND")
      ->group(what);
  app.add_flag("--terms", o.terms, "print D, G and F of a microfacet model")->group(what);
  app.add_flag("--furnace", o.furnace, "print the directional albedo, with its error")->group(what);
  app.add_flag("--reciprocity", o.reciprocity, "print the worst violation of f_r(l,v) = f_r(v,l)")
      ->group(what);
  app.add_option("--tabulate", o.table, "write the model as a measured table: merl or utia")
      ->type_name("FORMAT")
      ->group(what);
  const char* const how = "How";
  app.add_option("--precision", o.precision, "of --values: double, float or batch (double)")
      ->type_name("NAME")
      ->group(how);
  app.add_option("--angles", o.angles,
                 "the light's from the normal, as in 30,60; --furnace: the viewer's")
      ->type_name("DEG,...")
      ->group(how);
  app.add_option("--azimuth", o.azimuth, "of that direction, from the tangent (0)")
      ->type_name("DEG")
      ->group(how);
  app.add_option("--quantity", o.quantity, "polar, cartesian: value, pi f_r (n.l), or brdf (value)")
      ->type_name("NAME")
      ->group(how);
  app.add_flag("--log", o.logarithmic, "cartesian: a second panel with a logarithmic axis")
      ->group(how);
  app.add_option("--cell", o.cell, "side of one sphere or slice in pixels (280)")
      ->type_name("N")
      ->group(how);
  app.add_option("--exposure", o.exposure, "sphere, slice: each 1 more doubles the brightness (0)")
      ->type_name("EV")
      ->group(how);
}

}  // namespace

Command add_reflect_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("reflect", "Asks reflection models: values, plots, albedo");
  app->footer(
      "Examples:\n"
      "  scanlit reflect blinn-phong:ks=.4,n=50 --values directions.csv --precision batch\n"
      "  scanlit reflect phong:n=20 blinn-phong:n=80 --plot polar --angles 45 -o lobes.svg\n"
      "  scanlit reflect phong:n=20 blinn-phong:n=80 --plot sphere -o spheres.png\n"
      "  scanlit reflect fresnel:F=copper --plot spectrum -o copper.svg\n"
      "  scanlit reflect lambert:kd=.8 --furnace\n"
      "\n"
      "Directions leave the surface, in the shading frame (z is the normal, x the tangent), of\n"
      "length 1 to 0.00001; a header line may name the columns. Answers are r,g,b, a row each.\n"
      "Polar and cartesian plots lie in the plane of incidence; the axis is pi f_r (n.l), what\n"
      "is reflected of a light of intensity 1, or f_r in 1/sr. A sphere's light is so many\n"
      "degrees from the viewer's direction, towards the upper left. A slice is pi f_r at\n"
      "phi_d = 90 degrees.\n"
      "A spectrum is that of a metal: its F over wavelength and angle, and the colour of that.");
  const auto options = std::make_shared<ReflectOptions>();
  options->app = app;
  add_options(*app, *options);
  return {app, [options] { chosen_action(*options).run(*options); }};
}

}  // namespace scanlit::studio
