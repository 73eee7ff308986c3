#include "lessons/studio/reflect/reports.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "lessons/studio/reflect/model_part.h"
#include "lessons/studio/reflect/query.h"
#include "lessons/studio/reflect/reciprocity.h"
#include "lessons/studio/table.h"
#include "lessons/studio/text.h"
#include "models/albedo.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

std::string short_text(double value, int digits = 2) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string short_text(const Rgb<double>& value, int digits) {
  const std::string red = short_text(value.r, digits);
  if (value == Rgb<double>(value.r)) return red;
  return red + "/" + short_text(value.g, digits) + "/" + short_text(value.b, digits);
}

std::string text_of_direction(const Vec3<double>& a) {
  return fixed(a.x, 6) + "," + fixed(a.y, 6) + "," + fixed(a.z, 6);
}

double largest(const Rgb<double>& a) { return std::max({a.r, a.g, a.b}); }

}  // namespace

std::string furnace_report(const models::NamedModel& model, const std::vector<double>& angles_deg,
                           double azimuth_deg) {
  constexpr double tolerance = 1e-6;
  std::vector<std::vector<std::string>> rows{{"angle", "red", "green", "blue", "error below"}};
  bool bright = false, rough = false;
  for (const double angle_deg : angles_deg) {
    const auto albedo =
        models::directional_albedo(*model.model, direction_at(angle_deg, azimuth_deg), tolerance);
    rows.push_back({text_of(angle_deg), fixed(albedo.value.r, 6), fixed(albedo.value.g, 6),
                    fixed(albedo.value.b, 6), short_text(largest(albedo.error))});
    bright |= largest(albedo.value - albedo.error) > 1;
    rough |= largest(albedo.error) > tolerance;
  }
  std::ostringstream out;
  out << "Directional albedo of " << model.specification << "\n\n";
  print_columns(out, rows, "  ");
  if (bright) out << "\nAbove 1 a surface reflects more light than it gets.\n";
  if (rough)
    out << "\nWhere the error is above " << short_text(tolerance)
        << ", the integral was given up.\n";
  return out.str();
}

std::string reciprocity_report(const models::NamedModel& model) {
  const Violation worst = worst_violation(*model.model);
  const models::ModelInfo* info = find_info(model);
  std::ostringstream out;
  out << "Reciprocity of " << model.specification << "\n\n";
  print_columns(out,
                {{"largest violation",
                  short_text(worst.relative) + "  (|f_r(l,v) - f_r(v,l)| / the larger of the two)"},
                 {"at l", text_of_direction(worst.l)},
                 {"and v", text_of_direction(worst.v)},
                 {"f_r(l,v) [1/sr]", text_of(worst.forward)},
                 {"f_r(v,l) [1/sr]", text_of(worst.backward)},
                 {"declared", !info              ? "nothing"
                              : info->reciprocal ? "reciprocal"
                                                 : "not reciprocal"}},
                "  ");
  return out.str();
}

std::string terms_report(const models::NamedModel& model,
                         const std::vector<double>& light_angles_deg, double azimuth_deg) {
  if (!has_parts(model))
    throw Error("--terms", "'" + model.specification +
                               "' is not made of D, G and F; cook-torrance and torrance-sparrow "
                               "are");
  const ModelPart D(model, "distribution"), G(model, "masking"), F(model, "fresnel");
  std::ostringstream out;
  out << "D, G and F of " << model.specification << ", in the plane of incidence\n";
  for (const double light_deg : light_angles_deg) {
    std::vector<std::vector<std::string>> rows{
        {"viewer", "half vector", "D [1/sr]", "G", "F", "pi f_r (n.l)"}};
    const Vec3<double> l = direction_at(light_deg, azimuth_deg);
    for (const int view_deg : {-85, -75, -60, -45, -30, -15, 0, 15, 30, 45, 60, 75, 85}) {
      const Vec3<double> v = direction_at(-view_deg, azimuth_deg);
      rows.push_back({std::to_string(view_deg), text_of((view_deg - light_deg) / 2),
                      short_text(D(l, v).r, 5), short_text(G(l, v).r, 5), short_text(F(l, v), 5),
                      short_text(reflected(*model.model, l, v), 5)});
    }
    out << "\nLight at " << text_of(light_deg) << " degrees\n";
    print_columns(out, rows, "  ");
  }
  return out.str();
}

}  // namespace scanlit::studio
