#include "models/measured/utia.h"

#include <memory>
#include <string>

#include "models/measured/table_file.h"
#include "models/spherical.h"
#include "rasterizer/error.h"
#include "rasterizer/image/image_encoding.h"

namespace scanlit::models {
namespace {

constexpr int phi_count = UtiaTable::phi_count, theta_count = UtiaTable::theta_count;
constexpr std::uintmax_t file_size = 3 * sizeof(double) * UtiaTable::size;

/// Replaces the entries at(0) to at(phi_count - 1), all of one direction, by their mean.
template <class At>
void unite(const At& at) {
  Rgb<double> sum;
  for (int phi = 0; phi < phi_count; ++phi) sum = sum + at(phi);
  for (int phi = 0; phi < phi_count; ++phi) at(phi) = sum * (1.0 / phi_count);
}

NamedModel make_utia(const ModelInfo& info, std::span<const Argument> arguments,
                     const Context& context) {
  Values values = read_values(context, info.parameters, arguments);
  const auto& file = std::get<std::string>(value_of(values, "file"));
  const bool srgb = std::get<std::string>(value_of(values, "encoding")) == "srgb";
  auto model = std::make_shared<FormulaModel<Utia>>(
      Utia(read_utia(file), srgb ? UtiaEncoding::srgb : UtiaEncoding::linear,
           std::get<double>(value_of(values, "scale"))));
  return {.model = std::move(model), .values = std::move(values)};
}

}  // namespace

Entry utia_entry() {
  return {.info = {.year = 2014,
                   .name = "utia",
                   .title = "UTIA (a measured anisotropic material)",
                   .source = "Filip, Vavra 2014, Template-based sampling of anisotropic BRDFs",
                   .parameters = {{.key = "file",
                                   .kind = ParameterKind::file,
                                   .initial = "",
                                   .meaning = "a table of 3 * 288 * 288 numbers: x.bin"},
                                  {.key = "encoding",
                                   .kind = ParameterKind::choice,
                                   .initial = "linear",
                                   .choices = {"linear", "srgb"},
                                   .meaning = "how the file's numbers stand for f_r"},
                                  {.key = "scale",
                                   .initial = 1.0,
                                   .min = 0,
                                   .max = 1000,
                                   .meaning = "what f_r is multiplied by"}}},
          .make = &make_utia};
}

Vec3<double> UtiaTable::direction(int theta, int phi) {
  constexpr double degree = std::numbers::pi / 180;
  return spherical_direction(theta * theta_step_deg * degree, phi * phi_step_deg * degree);
}

UtiaTable read_utia(const std::filesystem::path& file) {
  TableFile in(file);
  if (in.size() != file_size)
    throw Error(in.name(), "the file is " + std::to_string(in.size()) +
                               " bytes long; a UTIA table is 3 * 288 * 288 * 8 = " +
                               std::to_string(file_size));
  return {in.read_planes(UtiaTable::size)};
}

void write_utia(const UtiaTable& table, const std::filesystem::path& file) {
  write_table(file, {}, table.entries);
}

Utia::Utia(const UtiaTable& table, UtiaEncoding encoding, double scale) : f_r_(table.entries) {
  const auto f_r = [&](double entry) {
    const double positive = max(entry, 0.0);
    const double linear = encoding == UtiaEncoding::srgb ? linear_from_srgb(positive) : positive;
    return scale * min(linear, max_table_entry);  // decoded, 1e30 would be 1e72 and leave float
  };
  for (Rgb<double>& e : f_r_) e = {f_r(e.r), f_r(e.g), f_r(e.b)};
  const int directions = UtiaTable::directions;
  for (int other = 0; other < directions; ++other)  // light at the pole, then viewer
    unite([&](int phi) -> auto& { return f_r_[UtiaTable::index(0, phi, 0, other)]; });
  for (int other = 0; other < directions; ++other)
    unite([&](int phi) -> auto& { return f_r_[UtiaTable::index(0, other, 0, phi)]; });
}

template <class T>
Rgb<T> Utia::interpolated(T theta_l, T phi_l, T theta_v, T phi_v) const {
  const auto tl = neighbours(theta_l, theta_count), tv = neighbours(theta_v, theta_count);
  const auto pl = periodic_neighbours(phi_l, phi_count), pv = periodic_neighbours(phi_v, phi_count);
  Rgb<T> sum;
  for (int corner = 0; corner < 16; ++corner) {
    const int i = corner >> 3, j = corner >> 2 & 1, k = corner >> 1 & 1, m = corner & 1;
    const T weight = tl.weight(i) * pl.weight(j) * tv.weight(k) * pv.weight(m);
    sum = sum + f_r_[UtiaTable::index(tl.row[i], pl.row[j], tv.row[k], pv.row[m])] * weight;
  }
  return sum;
}

template Rgb<double> Utia::interpolated(double, double, double, double) const;
template Rgb<float> Utia::interpolated(float, float, float, float) const;

}  // namespace scanlit::models
