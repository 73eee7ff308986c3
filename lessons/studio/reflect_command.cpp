// scanlit reflect
#include <array>
#include <iostream>
#include <memory>

#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "lessons/studio/reflect/pictures.h"
#include "lessons/studio/reflect/plots.h"
#include "lessons/studio/reflect/reports.h"
#include "lessons/studio/reflect/values.h"
#include "lessons/studio/text.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"
#include "rasterizer/image/output_file.h"

namespace scanlit::studio {
namespace {

constexpr Range incidence_range_deg{0, 89.9};  // at 90 no light arrives
constexpr Range sphere_light_range_deg{0, 180};
constexpr Range cell_range{16, 4096};

struct ReflectOptions {
  std::vector<std::string> models;
  std::string output, rows, plot, precision = "double", quantity = "value", angles, azimuth, cell,
                                  exposure;
  bool logarithmic = false, terms = false, furnace = false, reciprocity = false;
  CLI::App* app = nullptr;

  bool given(const std::string& option) const { return app->count(option) > 0; }
};

struct Action {
  const char* option;
  void (*run)(const ReflectOptions& options);
  std::vector<std::string> goes_with;  // options that mean something to it
};

std::vector<models::NamedModel> make_models(const ReflectOptions& options) {
  std::vector<models::NamedModel> result;
  for (const std::string& specification : options.models)
    result.push_back(models::make(specification));
  return result;
}

models::NamedModel make_only_model(const ReflectOptions& options, const std::string& action) {
  if (options.models.size() != 1)
    throw Error(action, "wants one model, not " + std::to_string(options.models.size()));
  return models::make(options.models[0]);
}

std::vector<double> angles_of(const ReflectOptions& options, std::vector<double> otherwise,
                              const Range& range) {
  if (!options.given("--angles")) return otherwise;
  std::vector<double> angles;
  for (std::string_view rest = options.angles;;) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    angles.push_back(parse_number("--angles", rest.substr(0, end), range));
    if (end == rest.size()) return angles;
    rest.remove_prefix(end + 1);
  }
}

double azimuth_of(const ReflectOptions& options) {
  return options.given("--azimuth") ? parse_number("--azimuth", options.azimuth, any_angle_deg) : 0;
}

void write_text(const std::string& text, const std::string& output) {
  if (output.empty()) {
    std::cout << text;
    return;
  }
  const HoldInterrupts until_written;
  OutputFile file(output);
  std::fwrite(text.data(), 1, text.size(), file.stream());
  file.commit();
}

void print_values(const ReflectOptions& options) {
  const Choices<Precision> precisions{
      {"double", Precision::double_}, {"float", Precision::float_}, {"batch", Precision::batch}};
  const Precision precision = choose("--precision", "precision", options.precision, precisions);
  const models::NamedModel model = make_only_model(options, "--values");
  const std::string file = options.rows.empty() ? "-" : options.rows;
  const auto rows = read_rows(read_all(file), file == "-" ? "standard input" : file);
  std::string text;
  for (const Rgb<double>& value : evaluate_rows(*model.model, rows, precision)) {
    char line[100];
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g\n", value.r, value.g, value.b);
    text += line;
  }
  write_text(text, options.output);
}

void print_furnace(const ReflectOptions& options) {
  const auto angles = angles_of(options, {0, 30, 60, 75, 85, 89}, incidence_range_deg);
  write_text(furnace_report(make_only_model(options, "--furnace"), angles, azimuth_of(options)),
             options.output);
}

void print_reciprocity(const ReflectOptions& options) {
  write_text(reciprocity_report(make_only_model(options, "--reciprocity")), options.output);
}

void print_terms(const ReflectOptions& options) {
  const auto angles = angles_of(options, {30, 60}, incidence_range_deg);
  write_text(terms_report(make_only_model(options, "--terms"), angles, azimuth_of(options)),
             options.output);
}

using PlotText = std::string (*)(const PlotRequest&);
using DrawPicture = Framebuffer (*)(const PictureRequest&);

void write_plot(const ReflectOptions& options, PlotText plot) {
  if (std::filesystem::path(options.output).extension() != ".svg")
    throw Error(options.output, "a " + options.plot + " plot is an .svg file");
  PlotRequest request;
  request.models = make_models(options);
  request.light_angles_deg = angles_of(options, {30, 60}, incidence_range_deg);
  request.azimuth_deg = azimuth_of(options);
  request.logarithmic = options.logarithmic;
  const Choices<Quantity> quantities{{"value", Quantity::value}, {"brdf", Quantity::brdf}};
  request.quantity = choose("--quantity", "quantity", options.quantity, quantities);
  OutputFile{options.output};  // nobody waits for a plot that has nowhere to go
  write_text(plot(request), options.output);
  std::cout << options.output << ": " << options.plot << " plot\n";
}

void write_picture(const ReflectOptions& options, DrawPicture draw) {
  check_image_target(options.output, 1, 1);
  PictureRequest request;
  request.models = make_models(options);
  request.light_angles_deg = angles_of(options, {0, 30, 60, 90}, sphere_light_range_deg);
  if (options.given("--cell")) request.cell = parse_integer("--cell", options.cell, cell_range);
  ImageOptions image;
  if (options.given("--exposure"))
    image.exposure_ev = parse_number("--exposure", options.exposure, exposure_range_ev);
  const Framebuffer picture = draw(request);
  const HoldInterrupts until_written;
  write_image(options.output, picture, image);
  std::cout << options.output << ": " << picture.width << " x " << picture.height << " pixels\n";
}

void plot(const ReflectOptions& options) {
  using Draw = void (*)(const ReflectOptions&);
  const Choices<Draw> kinds{
      {"polar", [](auto& o) { write_plot(o, plot_polar); }},
      {"cartesian", [](auto& o) { write_plot(o, plot_cartesian); }},
      {"albedo", [](auto& o) { write_plot(o, plot_albedo); }},
      {"sphere", [](auto& o) { write_picture(o, draw_spheres); }},
      {"slice", [](auto& o) { write_picture(o, draw_slices); }},
  };
  const Draw draw = choose("--plot", "plot", options.plot, kinds);
  if (options.output.empty()) throw Error("--plot", "wants the name of a file: -o FILE");
  draw(options);
}

const std::vector<Action>& actions() {
  static const std::vector<Action> all{
      {"--values", print_values, {"--precision"}},
      {"--plot", plot, {"--angles", "--azimuth", "--quantity", "--log", "--cell", "--exposure"}},
      {"--terms", print_terms, {"--angles", "--azimuth"}},
      {"--furnace", print_furnace, {"--angles", "--azimuth"}},
      {"--reciprocity", print_reciprocity, {}},
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
  app.add_option("--plot", o.plot, "polar, cartesian, albedo (.svg); sphere, slice (a picture)")
      ->type_name("KIND")
      ->group(what);
  app.add_flag("--terms", o.terms, "print D, G and F of a microfacet model")->group(what);
  app.add_flag("--furnace", o.furnace, "print the directional albedo, with its error")->group(what);
  app.add_flag("--reciprocity", o.reciprocity, "print the worst violation of f_r(l,v) = f_r(v,l)")
      ->group(what);
  const char* const how = "How";
  app.add_option("--precision", o.precision, "of --values: double, float or batch (double)")
      ->type_name("NAME")
      ->group(how);
  app.add_option("--angles", o.angles,
                 "from the normal, as in 30,60; --furnace: the viewer's, "
                 "else the light's; sphere: from the viewer")
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
      "  scanlit reflect lambert:kd=.8 --furnace\n"
      "\n"
      "Directions leave the surface, in the shading frame (z is the normal, x the tangent), with "
      "a\n"
      "length of 1 to 0.00001; a header line may name the columns. Answers are r,g,b, a row each.\n"
      "Polar and cartesian plots lie in the plane of incidence; the axis is pi f_r (n.l), what is\n"
      "reflected of a light of intensity 1, or f_r in 1/sr.");
  const auto options = std::make_shared<ReflectOptions>();
  options->app = app;
  add_options(*app, *options);
  return {app, [options] { chosen_action(*options).run(*options); }};
}

}  // namespace scanlit::studio
