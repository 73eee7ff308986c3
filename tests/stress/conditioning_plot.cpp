#include <cmath>
#include <cstdio>
#include <numbers>

#include "lessons/studio/reflect/panel.h"
#include "tests/stress/plots.h"
#include "tests/unit/model_conditioning.h"
#include "tests/unit/tested_models.h"

namespace scanlit::stress {

namespace {

using namespace test;

constexpr double light_deg = 45, bin_deg = 0.5;
constexpr int pairs_in_bin = 48;
constexpr double invisible = 1e-5;  // of the peak

/// The largest relative errors in a bin of viewing angles.
struct Bin {
  double angle_deg, single, batch;
  double directions;  // what rounding l or v alone changes
  double exponent;    // x, the least value in it being e^-x of the peak
};

Pair pair_at(double view_deg, double aside_deg) {
  const double degree = std::numbers::pi / 180;
  const double phi = (view_deg < 0 ? 0 : 180) + aside_deg;
  return {glm::vec3(at(std::cos(light_deg * degree), 0)),
          glm::vec3(at(std::cos(view_deg * degree), phi * degree))};
}

/// Of the glossy part, where there is one, in the mirror direction.
std::size_t brightest_channel(const ReflectionModel& model) {
  const Pair mirror = pair_at(light_deg, 0);
  const auto value = in_double(model, mirror.l, mirror.v);
  const auto glossy = std::max_element(value.begin() + 3, value.end());
  return *glossy > 0 ? std::size_t(glossy - value.begin())
                     : std::size_t(std::max_element(value.begin(), value.end()) - value.begin());
}

double peak_of(const ReflectionModel& model, std::size_t channel) {
  double peak = 0;
  for (double angle = -89; angle < 90; angle += 0.5) {
    const Pair pair = pair_at(angle, 0);
    peak = std::max(peak, in_double(model, pair.l, pair.v)[channel]);
  }
  return peak;
}

std::vector<Bin> errors(const ReflectionModel& model) {
  const std::size_t channel = brightest_channel(model);
  const double peak = peak_of(model, channel);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in_bin(-0.5, 0.5);
  std::vector<Bin> bins;
  for (double angle = -89.5; angle <= 89.6; angle += bin_deg) {
    std::vector<Pair> pairs;
    for (int i = 0; i < pairs_in_bin; ++i)
      pairs.push_back(pair_at(angle + bin_deg * in_bin(random), in_bin(random)));
    const auto batch = span_of(pairs).evaluate(model);
    Bin bin{angle, 0, 0, 0, 0};
    bool visible = false;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double exact = in_double(model, pairs[i].l, pairs[i].v)[channel];
      if (!(exact > invisible * peak)) continue;
      visible = true;
      bin.exponent = std::max(bin.exponent, std::log(peak / exact));
      const auto worse = [&](double error, double& worst) {
        worst = std::max(worst, error / exact);
      };
      worse(std::abs(double(in_float(model, pairs[i].l, pairs[i].v)[channel]) - exact), bin.single);
      worse(std::abs(double(batch[i][channel]) - exact), bin.batch);
      worse(conditioning(model, pairs[i], channel), bin.directions);
    }
    if (visible) bins.push_back(bin);
  }
  return bins;
}

std::string reason(const Bin& at) {
  const double error = std::max(at.single, at.batch), unit = 0x1p-24;
  char text[200];
  if (error <= 8 * unit) return "a few roundings, no digits lost";
  if (error <= 4 * at.directions) {
    const char* where = std::abs(at.angle_deg) > 80
                            ? "cos θ_v is small, and any change a large share of it"
                            : "the lobe is steep";
    std::snprintf(text, sizeof text, "%s: a rounding of L or V counts %.0f times", where,
                  at.directions / unit);
  } else if (error <= 16 * at.exponent * unit) {
    std::snprintf(text, sizeof text,
                  "the lobe's tail, e^−x with x = %.0f: a rounding of x counts x times",
                  at.exponent);
  } else {
    std::snprintf(text, sizeof text, "the formula: %.0f times what rounding L or V changes",
                  error / std::max(at.directions, unit));
  }
  return text;
}

std::string draw(const std::string& name, const std::vector<Bin>& bins, const std::string& why) {
  constexpr double left = 96, top = 148, width = 560, height = 300;
  studio::Svg svg(left + width + 30, top + height + 64, "Conditioning of " + name);
  svg.text({(left + width) / 2, 30}, name, {.size = 18, .anchor = "middle", .bold = true});
  const studio::Stroke strokes[] = {{"#D55E00", 2}, {"#0072B2", 2}, {"#777777", 1.8, "6 4"}};
  studio::draw_legend(svg, {left, 46},
                      {{"float against double", strokes[0]},
                       {"Batch against double", strokes[1]},
                       {"what one rounding of L or V changes", strokes[2]}},
                      width);
  svg.text({left, top - 28}, why, {.size = 13, .colour = "#444444", .formula = true});
  std::vector<studio::Curve> curves;
  for (const auto& [member, stroke] : {std::pair(&Bin::single, strokes[0]),
                                       {&Bin::batch, strokes[1]},
                                       {&Bin::directions, strokes[2]}}) {
    double last = -1000;
    for (const Bin& bin : bins) {
      if (bin.angle_deg > last + 1.5 * bin_deg) curves.push_back({stroke, {}});  // after a gap
      curves.back().points.push_back({last = bin.angle_deg, bin.*member});
    }
  }
  const studio::Panel panel(
      svg, {left, top, width, height},
      studio::angle_axis(-90, 90, 30, "viewing angle θ_v (the light is at −45°)"),
      studio::logarithmic_axis(1e-2, 6, "relative error"));
  panel.mark(-light_deg, "L", {"#333333", 1.2});
  panel.mark(light_deg, "R", {"#777777", 1, "5 4"});
  panel.draw(curves);
  return svg.finish();
}

}  // namespace

std::vector<Conditioning> plot_conditioning() {
  std::vector<Conditioning> all;
  for (const std::string& name : analytic_names()) {
    const std::string specification = tested(name).specifications.front();
    const std::vector<Bin> bins = errors(*models::make(specification).model);
    const auto error = [](const Bin& bin) { return std::max(bin.single, bin.batch); };
    const Bin& worst = *std::max_element(
        bins.begin(), bins.end(), [&](const Bin& a, const Bin& b) { return error(a) < error(b); });
    char text[64];
    std::snprintf(text, sizeof text, "worst %.1e at %.0f°: ", error(worst), worst.angle_deg);
    all.push_back({specification, draw(specification, bins, text + reason(worst)), error(worst),
                   worst.angle_deg, reason(worst)});
  }
  return all;
}

}  // namespace scanlit::stress
