#include "lessons/studio/reflect/actions.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "lessons/studio/program.h"
#include "lessons/studio/reflect/pictures.h"
#include "lessons/studio/reflect/plots.h"
#include "lessons/studio/reflect/query.h"
#include "lessons/studio/reflect/reports.h"
#include "lessons/studio/reflect/values.h"
#include "lessons/studio/text.h"
#include "models/measured/tabulate.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"
#include "rasterizer/image/output_file.h"

namespace scanlit::studio {
namespace {

constexpr Range incidence_range_deg{0, 89.9};  // at 90 no light arrives
constexpr Range sphere_light_range_deg{0, 180};
constexpr Range cell_range{16, 4096};

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

/// Throws Error for D, G or F.
void require_reflection(const models::NamedModel& model, const std::string& action) {
  if (is_part(model))
    throw Error(action, "'" + model.specification + "' is a part of models and reflects nothing");
}

models::NamedModel make_only_reflection(const ReflectOptions& options, const std::string& action) {
  const models::NamedModel model = make_only_model(options, action);
  require_reflection(model, action);
  return model;
}

std::vector<double> angles_of(const ReflectOptions& options, std::vector<double> otherwise,
                              const Range& range) {
  if (!options.given("--angles")) return otherwise;
  std::vector<double> angles;
  for (const std::string_view angle : models::split_outside_parentheses(options.angles, ','))
    angles.push_back(parse_number("--angles", angle, range));
  return angles;
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

void require_output(const ReflectOptions& options, const std::string& action) {
  if (options.output.empty()) throw Error(action, "wants the name of a file: -o FILE");
}

using PlotText = std::string (*)(const PlotRequest&);
using DrawPicture = Framebuffer (*)(const PictureRequest&);

void write_plot(const ReflectOptions& options, PlotText plot,
                const std::vector<double>& usual_angles_deg = {30, 60}) {
  if (std::filesystem::path(options.output).extension() != ".svg")
    throw Error(options.output, "a " + options.plot + " plot is an .svg file");
  PlotRequest request;
  request.models = make_models(options);
  for (const models::NamedModel& model : request.models)
    if (options.plot == "albedo") require_reflection(model, "--plot");
  request.light_angles_deg = angles_of(options, usual_angles_deg, incidence_range_deg);
  request.azimuth_deg = azimuth_of(options);
  request.logarithmic = options.logarithmic;
  const Choices<Quantity> quantities{{"value", Quantity::value}, {"brdf", Quantity::brdf}};
  request.quantity = choose("--quantity", "quantity", options.quantity, quantities);
  OutputFile{options.output};  // nobody waits for a plot that has nowhere to go
  write_text(plot(request), options.output);
  std::cout << options.output << ": " << options.plot << " plot\n";
}

void write_spectrum(const ReflectOptions& options) {
  write_plot(options, plot_spectrum, {0, 30, 60, 75, 85, 89});
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
  const ImageReport report = write_image(options.output, picture, image);
  if (report.clipped_pixels > 0)
    note(grouped(report.clipped_pixels) +
         " pixels are too bright and were clipped; a lower --exposure shows them");
  std::cout << options.output << ": " << picture.width << " x " << picture.height << " pixels\n";
}

}  // namespace

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
  write_text(
      furnace_report(make_only_reflection(options, "--furnace"), angles, azimuth_of(options)),
      options.output);
}

void print_reciprocity(const ReflectOptions& options) {
  write_text(reciprocity_report(make_only_reflection(options, "--reciprocity")), options.output);
}

void print_terms(const ReflectOptions& options) {
  const auto angles = angles_of(options, {30, 60}, incidence_range_deg);
  write_text(terms_report(make_only_model(options, "--terms"), angles, azimuth_of(options)),
             options.output);
}

void plot(const ReflectOptions& options) {
  struct Plot {
    void (*draw)(const ReflectOptions&);
    std::vector<std::string> takes;
  };
  const Choices<Plot> kinds{
      {"polar",
       {[](auto& o) { write_plot(o, plot_polar); }, {"--angles", "--azimuth", "--quantity"}}},
      {"cartesian",
       {[](auto& o) { write_plot(o, plot_cartesian); },
        {"--angles", "--azimuth", "--quantity", "--log"}}},
      {"albedo", {[](auto& o) { write_plot(o, plot_albedo); }, {"--azimuth"}}},
      {"spectrum", {write_spectrum, {"--angles"}}},
      {"sphere",
       {[](auto& o) { write_picture(o, draw_spheres); }, {"--angles", "--cell", "--exposure"}}},
      {"slice", {[](auto& o) { write_picture(o, draw_slices); }, {"--cell", "--exposure"}}},
  };
  const Plot kind = choose("--plot", "plot", options.plot, kinds);
  for (const char* option :
       {"--angles", "--azimuth", "--quantity", "--log", "--cell", "--exposure"})
    if (options.given(option) && std::ranges::find(kind.takes, option) == kind.takes.end())
      throw Error(option, "has no meaning to the plot '" + options.plot + "'");
  require_output(options, "--plot");
  kind.draw(options);
}

void write_table(const ReflectOptions& options) {
  using Tabulate = void (*)(const ReflectionModel&, const std::filesystem::path&);
  const Choices<Tabulate> formats{{"merl", models::tabulate_merl}, {"utia", models::tabulate_utia}};
  const Tabulate tabulate = choose("--tabulate", "format", options.table, formats);
  require_output(options, "--tabulate");
  const models::NamedModel model = make_only_reflection(options, "--tabulate");
  const HoldInterrupts until_written;
  tabulate(*model.model, options.output);
  std::cout << options.output << ": " << options.table << " table\n";
}

}  // namespace scanlit::studio
