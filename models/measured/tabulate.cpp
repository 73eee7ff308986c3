#include "models/measured/tabulate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "models/measured/merl.h"
#include "models/measured/table_file.h"
#include "models/measured/utia.h"
#include "rasterizer/error.h"

namespace scanlit::models {
namespace {

constexpr double pi = std::numbers::pi;

Rgb<double> f_r(const ReflectionModel& model, const LightAndViewer& at) {
  const Reflection<double> value = model.evaluate(at.l, at.v);
  return (value.diffuse + value.glossy) * (1 / (pi * at.l.z));
}

std::string text(const Vec3<double>& d) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "(%.3g, %.3g, %.3g)", d.x, d.y, d.z);
  return buffer;
}

/// f_r as a file may have it.
Rgb<double> tabulated(const ReflectionModel& model, const LightAndViewer& at,
                      const std::filesystem::path& file) {
  const Rgb<double> value = f_r(model, at);
  for (const double channel : {value.r, value.g, value.b})
    if (!(channel >= 0 && channel <= max_table_entry / 1500))
      throw Error(file.string(), "the model's f_r at l = " + text(at.l) + ", v = " + text(at.v) +
                                     " is " + std::to_string(channel) +
                                     ", which a table cannot hold");
  return value;
}

bool differ(const Rgb<double>& a, const Rgb<double>& b) {
  // Formulas of equal value differ by rounding: by 1e-11 for an exponent of 1e5.
  const auto apart = [](double x, double y) {
    return !(std::abs(x - y) <= 1e-7 * std::max(std::abs(x), std::abs(y)) + 1e-12);
  };
  return apart(a.r, b.r) || apart(a.g, b.g) || apart(a.b, b.b);
}

/// Tries the model out at directions all over the hemisphere and, because a sharp lobe would be
/// missed by these, at half vectors near the normal, as near as 1e-4.
void check_isotropic_and_reciprocal(const ReflectionModel& model,
                                    const std::filesystem::path& file) {
  std::mt19937 random(1);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  // Nearer to the horizon models may clamp N.V (min_n_v), which is not reciprocal.
  constexpr double lowest = 10 * min_n_v;
  for (int i = 0; i < 4000; ++i) {
    const double theta_h = i % 2 ? uniform(0, pi / 2) : pi / 2 * std::pow(10, uniform(-4, 0));
    const HalfDifference<double> angles{theta_h, uniform(0, pi / 2), uniform(-pi, pi)};
    const double phi_h = uniform(-pi, pi), turn = uniform(-pi, pi);
    const LightAndViewer at = directions(angles, phi_h);
    if (at.l.z < lowest || at.v.z < lowest) continue;
    const Rgb<double> value = f_r(model, at);
    const std::string where = "; at l = " + text(at.l) + ", v = " + text(at.v) + " it differs";
    if (differ(value, f_r(model, directions(angles, phi_h + turn))))
      throw Error(file.string(),
                  "a MERL table holds isotropic models, and this one changes when the surface is "
                  "turned about its normal" +
                      where);
    if (differ(value, f_r(model, {.l = at.v, .v = at.l})))
      throw Error(file.string(),
                  "a MERL table holds reciprocal models, and f_r of this one changes when light "
                  "and viewer change places" +
                      where);
  }
}

}  // namespace

void tabulate_merl(const ReflectionModel& model, const std::filesystem::path& file) {
  check_isotropic_and_reciprocal(model, file);
  MerlTable table{std::vector<Rgb<double>>(MerlTable::size, Rgb<double>(-1.0))};
  const Rgb<double> entry_of_f_r{1 / MerlTable::scale.r, 1 / MerlTable::scale.g,
                                 1 / MerlTable::scale.b};
  for (int h = 0; h < MerlTable::theta_h_bins; ++h)
    for (int d = 0; d < MerlTable::theta_d_bins; ++d)
      for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
        const LightAndViewer at = directions(MerlTable::centre(h, d, p));
        if (at.l.z < min_n_v || at.v.z < min_n_v) continue;
        table.entries[MerlTable::index(h, d, p)] = tabulated(model, at, file) * entry_of_f_r;
      }
  write_merl(table, file);
}

void tabulate_utia(const ReflectionModel& model, const std::filesystem::path& file) {
  UtiaTable table{std::vector<Rgb<double>>(UtiaTable::size)};
  const int phis = UtiaTable::phi_count;
  const int count = UtiaTable::directions;
  for (int l = 0; l < count; ++l)
    for (int v = 0; v < count; ++v) {
      const LightAndViewer at = {.l = UtiaTable::direction(l / phis, l % phis),
                                 .v = UtiaTable::direction(v / phis, v % phis)};
      table.entries[UtiaTable::index(0, l, 0, v)] = tabulated(model, at, file);
    }
  write_utia(table, file);
}

}  // namespace scanlit::models
