// UTIA: an anisotropic measured material, looked up in a table of light and viewer directions.
//
//   pi f_r(theta_l, phi_l, theta_v, phi_v) (N.L)
//
// Jiri Filip, Radomir Vavra, "Template-based sampling of anisotropic BRDFs", Pacific Graphics 2014:
// 150 materials, http://btf.utia.cas.cz. Format of a `.bin` file: no header; three planes of
// 288 * 288 float64, red, green, blue; theta at 0, 15 ... 75 degrees, phi at 0, 7.5 ... 352.5 from
// the tangent towards the bitangent. Each entry is a value at these angles, not of a bin.
//
//  * Between the angles f_r is interpolated linearly, in phi around the circle.
//  * Beyond 75 degrees f_r is held at its value there (N.L still falls). The database's own reader
//    continues the line through the last two values, below 0 for some materials.
//  * At theta = 0 phi has no meaning and the table has 48 entries for one direction: their mean is
//    used, so that the highlight's centre has one value from all sides.
//  * Negative entries, which measurements have, are taken for 0.
//
// As with MERL's table all of it is the glossy part. A material need not be reciprocal here.
//
// What the numbers are is not in the file. The database calls its colours sRGB under D65; readers
// in circulation take them for linear (A. Sztrajman's UTIA-brdf), or decode sRGB first (A. Fichet's
// brdf-snippets), or scale them (J. Dupuy's dj_brdf, in two ways). Hence the two parameters: by
// default an entry is f_r in 1/sr, linear.
#pragma once

#include <filesystem>
#include <numbers>
#include <vector>

#include "models/measured/table_lookup.h"
#include "models/registry.h"
#include "rasterizer/batch_trigonometry.h"
#include "rasterizer/formula_model.h"

namespace scanlit::models {

/// A table as the file has it.
struct UtiaTable {
  static constexpr int theta_count = 6, phi_count = 48;  // of the light and of the viewer alike
  static constexpr std::size_t directions = std::size_t(theta_count) * phi_count;
  static constexpr std::size_t size = directions * directions;
  static constexpr double theta_step_deg = 15, phi_step_deg = 7.5;

  std::vector<Rgb<double>> entries;  // `size` of them, ordered as index() says

  static std::size_t index(int theta_l, int phi_l, int theta_v, int phi_v) {
    return directions * std::size_t(phi_count * theta_l + phi_l) +
           std::size_t(phi_count * theta_v + phi_v);
  }
  /// Unit, in the shading frame.
  static Vec3<double> direction(int theta, int phi);
};

/// Throws Error with the file's name: it cannot be read, is not exactly 3 * 288 * 288 * 8 bytes
/// long (there is no other mark to know it by), holds what is not finite.
UtiaTable read_utia(const std::filesystem::path& file);
/// The same bytes as were read. Throws Error; no half-written file is left.
void write_utia(const UtiaTable& table, const std::filesystem::path& file);

enum class UtiaEncoding { linear, srgb };

/// A formula: FormulaModel<Utia> is the reflection model.
class Utia {
 public:
  /// f_r is the entry, decoded if it is encoded, times scale (>= 0).
  explicit Utia(const UtiaTable& table, UtiaEncoding encoding = UtiaEncoding::linear,
                double scale = 1);

  static constexpr bool has_bounds = false;  // between the table's entries it has none

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& frame) const {
    const auto theta = [](const Vec3<T>& d) {
      return T(degrees / UtiaTable::theta_step_deg) * atan2(sqrt(d.x * d.x + d.y * d.y), d.z);
    };
    const auto phi = [](const Vec3<T>& d) {
      return T(degrees / UtiaTable::phi_step_deg) * atan2(d.y, d.x);
    };
    const std::array<T, 4> rows = {theta(frame.l), phi(frame.l), theta(frame.v), phi(frame.v)};
    const Rgb<T> f_r = for_each_lane(rows, [this](auto... row) { return interpolated(row...); });
    return {.diffuse = Rgb<T>(T(0)), .glossy = f_r * (T(pi) * c.n_l)};
  }

 private:
  static constexpr double pi = std::numbers::pi, degrees = 180 / pi;

  template <class T>
  Rgb<T> interpolated(T theta_l, T phi_l, T theta_v, T phi_v) const;

  std::vector<Rgb<double>> f_r_;  // >= 0; one value at each pole
};

Entry utia_entry();
inline const bool utia_registered = add(utia_entry());

extern template Rgb<double> Utia::interpolated(double, double, double, double) const;
extern template Rgb<float> Utia::interpolated(float, float, float, float) const;

}  // namespace scanlit::models
