#include "models/metals.h"

#include <algorithm>
#include <cmath>

#include "models/fresnel.h"
#include "rasterizer/error.h"

namespace scanlit::models {
namespace {

// {wavelength in nm, n, k}. Copper, gold, silver: P. B. Johnson and R. W. Christy, "Optical
// constants of the noble metals", Phys. Rev. B 6, 4370, 1972. Chromium, iron, nickel, titanium: the
// same, "Optical constants of transition metals", Phys. Rev. B 9, 5056, 1974. Aluminium: A. D.
// Rakic, "Algorithm for the determination of intrinsic optical constants of metal films:
// application to aluminum", Appl. Opt. 34, 4755, 1995.

constexpr OpticalConstants aluminium[] = {
    {364.66, 0.39877, 4.3957}, {413.28, 0.52135, 5.0008}, {442.80, 0.60790, 5.3676},
    {476.87, 0.72780, 5.7781}, {516.60, 0.87340, 6.2418}, {563.57, 1.0728, 6.7839},
    {619.93, 1.3660, 7.4052},  {652.25, 1.5724, 7.7354},  {688.81, 1.8301, 8.0601},
    {729.32, 2.1606, 8.3565},  {774.91, 2.6154, 8.4914},  {794.78, 2.7675, 8.3866}};

constexpr OpticalConstants chromium[] = {
    {368, 1.87, 2.69}, {381, 1.92, 2.74}, {397, 2.00, 2.83}, {413, 2.08, 2.93},
    {431, 2.19, 3.04}, {451, 2.33, 3.14}, {471, 2.51, 3.24}, {496, 2.75, 3.30},
    {521, 2.94, 3.33}, {549, 3.18, 3.33}, {582, 3.22, 3.30}, {617, 3.17, 3.30},
    {659, 3.09, 3.34}, {704, 3.05, 3.39}, {756, 3.08, 3.42}, {821, 3.20, 3.48}};

constexpr OpticalConstants copper[] = {
    {367.9, 1.36, 1.975}, {381.5, 1.33, 2.045}, {397.4, 1.32, 2.116}, {413.3, 1.28, 2.207},
    {430.5, 1.25, 2.305}, {450.9, 1.24, 2.397}, {471.4, 1.25, 2.483}, {495.9, 1.22, 2.564},
    {520.9, 1.18, 2.608}, {548.6, 1.02, 2.577}, {582.1, 0.70, 2.704}, {616.8, 0.30, 3.205},
    {659.5, 0.22, 3.747}, {704.5, 0.21, 4.205}, {756.0, 0.24, 4.665}, {821.1, 0.26, 5.180}};

constexpr OpticalConstants gold[] = {
    {367.9, 1.48, 1.895}, {381.5, 1.46, 1.933}, {397.4, 1.47, 1.952}, {413.3, 1.46, 1.958},
    {430.5, 1.45, 1.948}, {450.9, 1.38, 1.914}, {471.4, 1.31, 1.849}, {495.9, 1.04, 1.833},
    {520.9, 0.62, 2.081}, {548.6, 0.43, 2.455}, {582.1, 0.29, 2.863}, {616.8, 0.21, 3.272},
    {659.5, 0.14, 3.697}, {704.5, 0.13, 4.103}, {756.0, 0.14, 4.542}, {821.1, 0.16, 5.083}};

constexpr OpticalConstants iron[] = {
    {368, 2.02, 2.43}, {381, 2.12, 2.50}, {397, 2.24, 2.58}, {413, 2.35, 2.65},
    {431, 2.48, 2.71}, {451, 2.59, 2.77}, {471, 2.67, 2.82}, {496, 2.74, 2.88},
    {521, 2.86, 2.91}, {549, 2.95, 2.93}, {582, 2.94, 2.99}, {617, 2.88, 3.05},
    {659, 2.92, 3.10}, {704, 2.86, 3.19}, {756, 2.87, 3.28}, {821, 2.94, 3.39}};

constexpr OpticalConstants nickel[] = {
    {368, 1.70, 2.40}, {381, 1.72, 2.48}, {397, 1.72, 2.57}, {413, 1.70, 2.69},
    {431, 1.71, 2.82}, {451, 1.73, 2.95}, {471, 1.78, 3.09}, {496, 1.82, 3.25},
    {521, 1.85, 3.42}, {549, 1.92, 3.61}, {582, 1.96, 3.80}, {617, 1.99, 4.02},
    {659, 1.99, 4.26}, {704, 2.06, 4.50}, {756, 2.13, 4.73}, {821, 2.26, 4.97}};

constexpr OpticalConstants silver[] = {
    {367.9, 0.07, 1.657}, {381.5, 0.05, 1.864}, {397.4, 0.05, 2.070}, {413.3, 0.05, 2.275},
    {430.5, 0.04, 2.462}, {450.9, 0.04, 2.657}, {471.4, 0.05, 2.869}, {495.9, 0.05, 3.093},
    {520.9, 0.05, 3.324}, {548.6, 0.06, 3.586}, {582.1, 0.05, 3.858}, {616.8, 0.06, 4.152},
    {659.5, 0.05, 4.483}, {704.5, 0.04, 4.838}, {756.0, 0.03, 5.242}, {821.1, 0.04, 5.727}};

constexpr OpticalConstants titanium[] = {
    {368, 1.90, 2.90}, {381, 1.99, 2.93}, {397, 2.08, 2.95}, {413, 2.14, 2.98},
    {431, 2.21, 3.01}, {451, 2.27, 3.04}, {471, 2.32, 3.10}, {496, 2.36, 3.19},
    {521, 2.44, 3.30}, {549, 2.54, 3.43}, {582, 2.60, 3.58}, {617, 2.67, 3.72},
    {659, 2.76, 3.84}, {704, 2.86, 3.96}, {756, 3.00, 4.01}, {821, 3.21, 4.01}};

constexpr const char* noble = "Johnson and Christy 1972";
constexpr const char* transition = "Johnson and Christy 1974";

}  // namespace

OpticalConstants Metal::at(double wavelength_nm) const {
  const auto above =
      std::ranges::upper_bound(table, wavelength_nm, {}, &OpticalConstants::wavelength_nm);
  if (above == table.begin()) return {wavelength_nm, table.front().n, table.front().k};
  if (above == table.end()) return {wavelength_nm, table.back().n, table.back().k};
  const OpticalConstants &a = above[-1], &b = *above;
  const double t = (wavelength_nm - a.wavelength_nm) / (b.wavelength_nm - a.wavelength_nm);
  return {wavelength_nm, std::lerp(a.n, b.n, t), std::lerp(a.k, b.k, t)};
}

const std::vector<Metal>& metals() {
  static const std::vector<Metal> all{{"aluminium", "Rakic 1995", aluminium},
                                      {"chromium", transition, chromium},
                                      {"copper", noble, copper},
                                      {"gold", noble, gold},
                                      {"iron", transition, iron},
                                      {"nickel", transition, nickel},
                                      {"silver", noble, silver},
                                      {"titanium", transition, titanium}};
  return all;
}

const std::vector<std::string>& metal_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Metal& metal : metals()) all.push_back(metal.name);
    return all;
  }();
  return names;
}

const Metal& find_metal(std::string_view name) {
  const auto found = std::ranges::find(metals(), name, &Metal::name);
  if (found == metals().end())
    throw Error("unknown metal '" + std::string(name) + "'" + did_you_mean(name, metal_names()));
  return *found;
}

int metal_index(std::string_view name) { return int(&find_metal(name) - metals().data()); }

const MetalFresnel& metal(std::string_view name) {
  static const std::vector<MetalFresnel> fits(metals().begin(), metals().end());
  return fits[std::size_t(metal_index(name))];
}

double reflectance(const Metal& metal, double wavelength_nm, double cos_theta) {
  const OpticalConstants m = metal.at(wavelength_nm);
  return conductor_reflectance(cos_theta, m.n, m.k);
}

Rgb<double> spectral_rgb(const Metal& metal, double cos_theta, Illuminant light) {
  return linear_srgb([&](double nm) { return reflectance(metal, nm, cos_theta); }, light);
}

// Not the clamped curve is interpolated but the smooth one, at Chebyshev's nodes in x, which spread
// the error evenly; evaluation clamps.
MetalFresnel::MetalFresnel(const Metal& metal) {
  const auto x = chebyshev_nodes<size>();
  std::array<double, size> red, green, blue;
  for (std::size_t i = 0; i < size; ++i) {
    const double c = 0.3 * x[i] / (1.3 - x[i]);  // compressed(c) = x[i]
    const Rgb<double> f = spectral_rgb(metal, c);
    red[i] = (1 - f.r) / x[i], green[i] = (1 - f.g) / x[i], blue[i] = (1 - f.b) / x[i];
  }
  red_ = interpolate(x, red), green_ = interpolate(x, green), blue_ = interpolate(x, blue);
}

}  // namespace scanlit::models
