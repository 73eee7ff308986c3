#include "models/lafortune.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "rasterizer/error.h"

namespace scanlit::models {

LafortuneLobe::LafortuneLobe(const Vec3<double>& c, double n) : n_(n) {
  const double largest = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
  const double peak = std::pow(largest, n);
  if (!(peak <= max_peak)) {
    char text[160];
    std::snprintf(text, sizeof text, "max(|cx|, |cy|, |cz|)^n is %g^%g = %g; allowed is at most %g",
                  largest, n, peak, max_peak);
    throw Error(text);
  }
  pi_peak_ = std::numbers::pi * peak;
  const auto share = [&](double x) { return largest > 0 ? std::abs(x) / largest : 0; };
  const auto sign = [](double x) { return x < 0 ? -1.0 : 1.0; };
  share_ = {share(c.x), share(c.y), share(c.z)};
  sign_ = {sign(c.x), sign(c.y), sign(c.z)};
}

namespace {

std::vector<ParameterInfo> lobe_parameters() {
  const auto colour = [](const char* key, double initial, double min, double max) {
    return ParameterInfo{.key = key,
                         .kind = ParameterKind::colour,
                         .initial = Rgb<double>(initial),
                         .min = min,
                         .max = max};
  };
  return {colour("cx", -1, -10, 10), colour("cy", -1, -10, 10), colour("cz", 1, -10, 10),
          colour("n", 20, 0, 1e5)};
}

/// "(cx=..,cy=..,cz=..,n=..)"
std::array<LafortuneLobe, 3> read_lobe(const Context& context, const std::string& text) {
  if (!text.starts_with('('))
    throw Error(context.where, "'lobe' wants (cx=..,cz=..,n=..), not '" + text + "'");
  const Context inside{context.where + ", lobe", context.folder, context.depth};
  std::vector<Argument> arguments = parse_call("lobe" + text).arguments;
  const auto given = [&](const char* key) {
    return std::ranges::find(arguments, key, &Argument::key);
  };
  if (const auto cx = given("cx"); cx != arguments.end() && given("cy") == arguments.end())
    arguments.push_back({"cy", cx->value});
  const Values values = read_values(inside, lobe_parameters(), arguments);
  const auto of = [&](const char* key) { return colour_of(value_of(values, key)); };
  const Rgb<double> cx = of("cx"), cy = of("cy"), cz = of("cz"), n = of("n");
  try {
    return {LafortuneLobe({cx.r, cy.r, cz.r}, n.r), LafortuneLobe({cx.g, cy.g, cz.g}, n.g),
            LafortuneLobe({cx.b, cy.b, cz.b}, n.b)};
  } catch (const Error& error) {
    throw Error(inside.where, error.what());
  }
}

NamedModel make_lafortune(const ModelInfo& info, std::span<const Argument> arguments,
                          const Context& context) {
  std::vector<Argument> others;
  std::string lobes;  // as they were written
  Lafortune formula;
  for (const Argument& argument : arguments)
    if (argument.key == "lobe") {
      formula.lobes.push_back(read_lobe(context, argument.value));
      lobes += argument.value;
    } else {
      others.push_back(argument);
    }
  Values values = read_values(context, info.parameters, others);
  if (lobes.empty())
    formula.lobes = {read_lobe(context, std::get<std::string>(value_of(values, "lobe")))};
  else
    std::ranges::find(values, "lobe", &Values::value_type::first)->second = lobes;
  formula.rd = colour_of(value_of(values, "rd"));
  return {.model = std::make_shared<FormulaModel<Lafortune>>(std::move(formula)),
          .values = std::move(values)};
}

}  // namespace

Entry lafortune_entry() {
  return {.info = {.year = 1997,
                   .name = "lafortune",
                   .title = "Lafortune, a sum of cosine lobes",
                   .source = "Lafortune, Foo, Torrance and Greenberg 1997, Non-linear "
                             "approximation of reflectance functions",
                   .reciprocal = true,
                   .energy_bounded = false,
                   .exceptions = "material:blue-house-paint is energy-bounded",
                   .parameters = {{.key = "rd",
                                   .kind = ParameterKind::colour,
                                   .initial = Rgb<double>(0.3),
                                   .max = 1,
                                   .meaning = "diffuse reflectance"},
                                  {.key = "lobe",
                                   .kind = ParameterKind::group,
                                   .initial = "(cx=-1,cz=.98,n=20)",
                                   .meaning = "any number of lobes; cx, cy (cx if not given), cz "
                                              "-10 to 10 and n 0 to 1e5, each per channel"}}},
          .make = &make_lafortune};
}

}  // namespace scanlit::models
