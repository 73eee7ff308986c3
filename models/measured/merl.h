// MERL: an isotropic measured material, looked up in a table.
//
//   pi f_r(theta_h, theta_d, phi_d) (N.L)
//
// Wojciech Matusik, Hanspeter Pfister, Matt Brand, Leonard McMillan, "A data-driven reflectance
// model", SIGGRAPH 2003. The 100 published `.binary` files are measurements of spheres. Format:
// three int32, 90 90 180, then three planes of 90 * 90 * 180 float64, red, green, blue; angles as
// in half_difference.h; a negative entry is one that could not be measured.
//
// A table does not know its parts. All of it is the glossy part: its colour is the material's own,
// and an ambient share of a measured highlight would be none of light from everywhere. phi_d is
// folded to [0, pi): the table holds reciprocal materials only; -phi_d, the mirror image, is
// another entry.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "models/measured/half_difference.h"
#include "models/registry.h"
#include "rasterizer/reflection_model.h"

namespace scanlit::models {

/// A table as the file has it: unscaled, with its negative entries.
struct MerlTable {
  static constexpr std::int32_t theta_h_bins = 90, theta_d_bins = 90, phi_d_bins = 180;
  static constexpr std::size_t size = std::size_t(theta_h_bins) * theta_d_bins * phi_d_bins;
  /// From an entry to f_r in 1/sr, as published.
  static inline const Rgb<double> scale{1.0 / 1500, 1.15 / 1500, 1.66 / 1500};

  std::vector<Rgb<double>> entries;  // `size` of them, ordered as index() says

  static std::size_t index(int theta_h_bin, int theta_d_bin, int phi_d_bin) {
    return std::size_t(phi_d_bin + phi_d_bins * (theta_d_bin + theta_d_bins * theta_h_bin));
  }
  /// The angles at a bin's centre. Bins of theta_d and phi_d are 1 degree wide; of theta_h, with
  /// borders at i^2/90 degrees, the narrowest are at the highlight's centre.
  static HalfDifference<double> centre(int theta_h_bin, int theta_d_bin, int phi_d_bin);
};

/// Throws Error with the file's name: it cannot be read, has other dimensions than 90 90 180, is
/// shorter or longer than these, holds what is not finite.
MerlTable read_merl(const std::filesystem::path& file);
/// The same bytes as were read. Throws Error; no half-written file is left.
void write_merl(const MerlTable& table, const std::filesystem::path& file);

/// nearest: the entry of the bin, as the published code has it; a bin that was not measured is 0.
/// Its borders are visible. trilinear: between the centres of the eight bins around, in bins (not
/// degrees) of theta_h; periodic in phi_d; beyond the first and last centre of theta_h and theta_d
/// held. Of the eight, those not measured are left out; where none is left the value is 0.
enum class MerlLookup { nearest, trilinear };

class Merl final : public ReflectionModel {
 public:
  explicit Merl(MerlTable table, MerlLookup lookup = MerlLookup::trilinear)
      : table_(std::move(table)), lookup_(lookup) {}

  Needs needs() const override { return {}; }
  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override;
  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point = {}) const override;
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point = {}) const override;

 private:
  template <class T>
  Rgb<T> reflection(const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v) const;
  template <class T>
  Rgb<T> nearest(T theta_h_bins, T theta_d_bins, T phi_d_bins) const;
  template <class T>
  Rgb<T> trilinear(T theta_h_bins, T theta_d_bins, T phi_d_bins) const;

  MerlTable table_;
  MerlLookup lookup_;
};

Entry merl_entry();
inline const bool merl_registered = add(merl_entry());

}  // namespace scanlit::models
