#include "lessons/studio/reflect/reports.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "lessons/studio/reflect/query.h"
#include "lessons/studio/reflect/reciprocity.h"
#include "lessons/studio/table.h"
#include "lessons/studio/text.h"
#include "models/albedo.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string short_text(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

std::string text_of_direction(const Vec3<double>& a) {
  return fixed(a.x, 6) + "," + fixed(a.y, 6) + "," + fixed(a.z, 6);
}

double largest(const Rgb<double>& a) { return std::max({a.r, a.g, a.b}); }

const models::ModelInfo& info_of(const models::NamedModel& model) {
  const std::string name = models::parse_specification(model.specification).name;
  return *std::ranges::find(models::list(), name, &models::ModelInfo::name);
}

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
  std::ostringstream out;
  out << "Reciprocity of " << model.specification << "\n\n";
  print_columns(out,
                {{"largest violation",
                  short_text(worst.relative) + "  (|f_r(l,v) - f_r(v,l)| / the larger of the two)"},
                 {"at l", text_of_direction(worst.l)},
                 {"and v", text_of_direction(worst.v)},
                 {"f_r(l,v) [1/sr]", text_of(worst.forward)},
                 {"f_r(v,l) [1/sr]", text_of(worst.backward)},
                 {"declared", info_of(model).reciprocal ? "reciprocal" : "not reciprocal"}},
                "  ");
  return out.str();
}

std::string terms_report(const models::NamedModel& model,
                         const std::vector<double>& light_angles_deg, double azimuth_deg) {
  const models::Specification given = models::parse_specification(model.specification);
  const std::vector<std::string> with_terms{"cook-torrance", "torrance-sparrow"};
  if (std::ranges::find(with_terms, given.name) == with_terms.end())
    throw Error(
        "--terms",
        "'" + given.name + "' is not made of D, G and F; cook-torrance and torrance-sparrow are");
  (void)light_angles_deg, (void)azimuth_deg;  // TODO
  return "";
}

}  // namespace scanlit::studio
