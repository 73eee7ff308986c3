#include "models/measured/merl.h"

#include <array>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "models/measured/table_file.h"
#include "models/measured/table_lookup.h"
#include "rasterizer/error.h"
#include "rasterizer/formula_model.h"

namespace scanlit::models {
namespace {

constexpr double pi = std::numbers::pi;

constexpr std::array<std::int32_t, 3> dimensions = {MerlTable::theta_h_bins,
                                                    MerlTable::theta_d_bins, MerlTable::phi_d_bins};
constexpr std::uintmax_t file_size = sizeof dimensions + 3 * sizeof(double) * MerlTable::size;

NamedModel make_merl(const ModelInfo& info, std::span<const Argument> arguments,
                     const Context& context) {
  Values values = read_values(context, info.parameters, arguments);
  const auto& file = std::get<std::string>(value_of(values, "file"));
  const bool nearest = std::get<std::string>(value_of(values, "lookup")) == "nearest";
  auto model = std::make_shared<Merl>(read_merl(file),
                                      nearest ? MerlLookup::nearest : MerlLookup::trilinear);
  return {.model = std::move(model), .values = std::move(values)};
}

// As in the published look-up, one negative channel condemns the entry.
bool measured(const Rgb<double>& entry) { return entry.r >= 0 && entry.g >= 0 && entry.b >= 0; }

}  // namespace

Entry merl_entry() {
  return {
      .info = {.year = 2003,
               .name = "merl",
               .title = "MERL (a measured isotropic material)",
               .source = "Matusik, Pfister, Brand, McMillan 2003, A data-driven reflectance model; "
                         "angles: Rusinkiewicz 1998, A new change of variables for efficient BRDF "
                         "representation",
               .reciprocal = true,
               .parameters = {{.key = "file",
                               .kind = ParameterKind::file,
                               .initial = "",
                               .meaning = "a table of 90 90 180 bins, as published: x.binary"},
                              {.key = "lookup",
                               .kind = ParameterKind::choice,
                               .initial = "trilinear",
                               .choices = {"nearest", "trilinear"},
                               .meaning = "the bin's entry, or between the centres of bins"}}},
      .make = &make_merl};
}

HalfDifference<double> MerlTable::centre(int theta_h_bin, int theta_d_bin, int phi_d_bin) {
  const double h = (theta_h_bin + 0.5) / theta_h_bins;
  return {.theta_h = h * h * pi / 2,
          .theta_d = (theta_d_bin + 0.5) / theta_d_bins * pi / 2,
          .phi_d = (phi_d_bin + 0.5) / phi_d_bins * pi};
}

MerlTable read_merl(const std::filesystem::path& file) {
  TableFile in(file);
  const std::string wanted =
      "; a MERL table has 90 90 180 bins, " + std::to_string(file_size) + " bytes in all";
  std::array<std::int32_t, 3> found{};
  if (in.size() < sizeof found)
    throw Error(in.name(), "the file ends before its dimensions" + wanted);
  in.read(found.data(), sizeof found);
  if (found != dimensions) {
    std::string text = "the dimensions are";
    for (const std::int32_t bins : found) text += " " + std::to_string(bins);
    throw Error(in.name(), text + wanted);
  }
  if (in.size() != file_size)
    throw Error(in.name(), "the file is " + std::to_string(in.size()) + " bytes long" + wanted);
  return {in.read_planes(MerlTable::size)};
}

void write_merl(const MerlTable& table, const std::filesystem::path& file) {
  write_table(file, dimensions, table.entries);
}

template <class T>
Rgb<T> Merl::nearest(T theta_h_bins, T theta_d_bins, T phi_d_bins) const {
  const auto& entry =
      table_.entries[MerlTable::index(containing_row(theta_h_bins, MerlTable::theta_h_bins),
                                      containing_row(theta_d_bins, MerlTable::theta_d_bins),
                                      containing_row(phi_d_bins, MerlTable::phi_d_bins))];
  return measured(entry) ? entry * Rgb<T>(T(1)) : Rgb<T>();
}

template <class T>
Rgb<T> Merl::trilinear(T theta_h_bins, T theta_d_bins, T phi_d_bins) const {
  const T half(0.5);  // from a bin's first border to its centre
  const auto h = neighbours(theta_h_bins - half, MerlTable::theta_h_bins);
  const auto d = neighbours(theta_d_bins - half, MerlTable::theta_d_bins);
  const auto p = periodic_neighbours(phi_d_bins - half, MerlTable::phi_d_bins);
  Rgb<T> sum;
  T weights(0);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        const auto& entry = table_.entries[MerlTable::index(h.row[i], d.row[j], p.row[k])];
        if (!measured(entry)) continue;
        const T weight = h.weight(i) * d.weight(j) * p.weight(k);
        sum = sum + entry * weight;
        weights = weights + weight;
      }
  // Less is what rounding of coordinates leaves to bins that have no share: one of them would stand
  // for all.
  return weights > T(1e-4) ? sum * (T(1) / weights) : Rgb<T>();
}

template <class T>
Rgb<T> Merl::reflection(const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v) const {
  const HalfDifference<T> angles = half_difference(n, l, visible(n, v));
  const T folded = select(angles.phi_d < T(0), angles.phi_d + T(pi), angles.phi_d);
  const std::array<T, 3> bins = {sqrt(angles.theta_h * T(2 / pi)) * T(MerlTable::theta_h_bins),
                                 angles.theta_d * T(2 / pi * MerlTable::theta_d_bins),
                                 folded * T(MerlTable::phi_d_bins / pi)};
  const Rgb<T> entry = for_each_lane(bins, [this](auto... b) {
    return lookup_ == MerlLookup::nearest ? nearest(b...) : trilinear(b...);
  });
  const T n_l = min(T(1), dot(n, l));
  return MerlTable::scale * (entry * select(n_l > T(0), T(pi) * n_l, T(0)));
}

void Merl::evaluate(const DirectionSpan& in, const ReflectionSpan& out) const {
  for (std::size_t i = 0; i < in.size; i += Batch::lanes)
    store(Reflection<Batch>{.diffuse = Rgb<Batch>(Batch(0.0f)),
                            .glossy = reflection(load_vec3(in.normal, i), load_vec3(in.to_light, i),
                                                 load_vec3(in.to_viewer, i))},
          out, i);
}

Reflection<double> Merl::evaluate(const Vec3<double>& l, const Vec3<double>& v,
                                  const SurfacePoint<double>& point) const {
  if (!(v.z > 0) && !point.drawn) return {};
  return {.diffuse = {}, .glossy = reflection({0, 0, 1}, l, v)};
}
Reflection<float> Merl::evaluate(const Vec3<float>& l, const Vec3<float>& v,
                                 const SurfacePoint<float>& point) const {
  if (!(v.z > 0) && !point.drawn) return {};
  return {.diffuse = {}, .glossy = reflection({0, 0, 1}, l, v)};
}

}  // namespace scanlit::models
