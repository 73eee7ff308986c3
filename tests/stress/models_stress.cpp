// Every model of the registry, with its parameters at their limits and in any combination, at the
// limits of the hemisphere.
#include <map>

#include "rasterizer/error.h"
#include "tests/stress/property.h"
#include "tests/unit/model_conditioning.h"
#include "tests/unit/tested_models.h"

namespace scanlit::stress {
namespace {

using namespace test;

/// A value anywhere in a range, its ends and their neighbours often; one that float can tell from
/// them: an exponent of 1e-320 is 0 in float, and 0^0 is not 0.
double random_value(Property& property, double min, double max) {
  const float low = float(min), high = float(max);
  const auto value = [&]() -> double {
    switch (property.whole(0, 6)) {
      case 0: return min;
      case 1: return max;
      case 2: return double(std::nextafter(low, high));
      case 3: return double(std::nextafter(high, low));
      case 4: return property.uniform(min, max);
      default:  // by decades, from a range's lower end or from 1e-9 of its upper one
        const double first = std::max({std::abs(min), 1e-9 * max, 1e-30});
        return property.decades(std::log10(first), std::log10(std::max(max, 2 * first)));
    }
  };
  return std::clamp(value(), min, max);
}

bool has_meaning(const std::string& only_with, const std::map<std::string, std::string>& chosen) {
  if (only_with.empty()) return true;
  const auto equals = only_with.find('=');
  const auto found = chosen.find(only_with.substr(0, equals));
  for (const auto word :
       models::split_outside_parentheses(std::string_view(only_with).substr(equals + 1), '|'))
    if (found != chosen.end() && found->second == word) return true;
  return false;
}

/// "NAME:key=value,...", each parameter that has a meaning given or not.
std::string random_specification(const models::ModelInfo& info, Property& property) {
  std::map<std::string, std::string> chosen;
  std::string arguments;
  for (const bool choices : {true, false})
    for (const auto& p : info.parameters) {
      using enum models::ParameterKind;
      if ((p.kind == choice) != choices || !has_meaning(p.only_with, chosen)) continue;
      const bool given = property.whole(0, 3) > 0;
      std::string value;
      if (p.kind == choice) {
        value = given ? p.choices[std::size_t(property.whole(0, int(p.choices.size()) - 1))]
                      : std::get<std::string>(p.initial);
        chosen[p.key] = value;
      } else if (p.kind == number || p.kind == colour) {
        const int count = p.kind == colour && property.coin() ? 3 : 1;
        for (int c = 0; c < count; ++c)
          value += (c ? "/" : "") + text(random_value(property, p.min, p.max));
      }
      if (given && !value.empty())
        arguments += (arguments.empty() ? ":" : ",") + p.key + "=" + value;
    }
  return info.name + arguments;
}

/// A model and what it was made from; of tables and of models of models, one of a fixed list.
struct Made {
  std::string specification;
  models::NamedModel named;
};
Made random_model(Property& property) {
  static const std::vector<Tested> all = [] {
    std::vector<Tested> result;
    for (const std::string& name : all_names()) result.push_back(tested(name));
    return result;
  }();
  for (;;) {
    const Tested& model = all[std::size_t(property.whole(0, int(all.size()) - 1))];
    const bool listed = model.measured || !model.info.example.empty() || property.whole(0, 9) == 0;
    const auto& list = model.specifications;
    const std::string specification =
        listed ? list[std::size_t(property.whole(0, int(list.size()) - 1))]
               : random_specification(model.info, property);
    try {
      return {specification, models::make(specification)};
    } catch (const Error& error) {  // such as parameters that exclude one another
      EXPECT_GT(std::string(error.what()).size(), 20u);
    }
  }
}

/// Often at the horizon, above and below, and at the normal.
double random_cosine(Property& property) {
  switch (property.whole(0, 5)) {
    case 0: return property.any_of(1.0, 0.0, min_n_v, 1e-7, -1e-7);
    case 1: return property.decades(-9, 0);
    case 2: return 1 - property.decades(-9, 0);
    case 3: return -property.decades(-9, 0);
    default: return property.uniform(0, 1);
  }
}

Pair random_pair(Property& property) {
  const double phi = property.any_of(0.0, property.uniform(-4, 4));
  const glm::dvec3 l = at(random_cosine(property), phi);
  const double turn = property.any_of(0.0, std::numbers::pi, property.uniform(-4, 4)) +
                      property.any_of(0.0, property.decades(-9, -1));
  glm::dvec3 v = at(random_cosine(property), phi + turn);
  switch (property.whole(0, 4)) {
    case 0: v = l; break;
    case 1: v = {-l.x, -l.y, l.z}; break;
    case 2: v = -l; break;
    default: break;
  }
  if (property.coin()) v = glm::normalize(v + property.decades(-9, -1) * v.z * glm::dvec3(1, 1, 1));
  return {glm::vec3(l), glm::vec3(v)};
}

std::string words(const std::string& specification, const Pair& pair) {
  std::ostringstream text;
  text.precision(9);
  text << specification << " at l " << pair.l.x << ' ' << pair.l.y << ' ' << pair.l.z << ", v "
       << pair.v.x << ' ' << pair.v.y << ' ' << pair.v.z;
  return text.str();
}

constexpr std::size_t pairs_a_case = 64;

std::vector<Pair> random_pairs(Property& property) {
  std::vector<Pair> pairs;
  while (pairs.size() < pairs_a_case) pairs.push_back(random_pair(property));
  return pairs;
}

TEST(Models, FiniteAtEveryLimit) {
  Property property{"double, float and Batch are finite, not negative, and 0 below the horizon",
                    "every model of the registry; parameters at the ends of their ranges, next to "
                    "them and between, in any combination; directions at and next to the normal, "
                    "the horizon, one another, the mirror direction, opposite",
                    "values with a fault", 6000};
  while (property.next()) {
    const Made model = random_model(property);
    const std::vector<Pair> pairs = random_pairs(property);
    const auto batch = span_of(pairs).evaluate(*model.named.model);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto exact = in_double(*model.named.model, pairs[i].l, pairs[i].v);
      const auto single = in_float(*model.named.model, pairs[i].l, pairs[i].v);
      int faults = 0;
      const bool lit = pairs[i].l.z > 0, seen = pairs[i].v.z > 0;
      for (std::size_t c = 0; c < 6; ++c) {
        const auto good = [&](double x, bool dark) {
          return std::isfinite(x) && x >= 0 && (!dark || x == 0);
        };
        faults += !good(exact[c], !lit || !seen) + !good(double(single[c]), !lit || !seen) +
                  !good(double(batch[i][c]), !lit);
      }
      property.measure(faults, words(model.specification, pairs[i]));
      EXPECT_EQ(faults, 0) << words(model.specification, pairs[i]);
    }
  }
}

TEST(Models, FloatAndBatchAgreeWithDouble) {
  Property property{
      "float and Batch equal double, but for what rounding the directions changes",
      "as above, light and viewer above the horizon by more than 1e-3",
      "of the allowed error (2e-5 of the peak or of 1e-3, times sqrt(n / 1000) for lobes "
      "sharper than n = 1000, and what 8 roundings of the directions change)",
      3000};
  while (property.next()) {
    const Made model = random_model(property);
    const bool table = model.specification.find("file=") != std::string::npos;
    const ReflectionModel& in = *model.named.model;
    std::vector<Pair> pairs = random_pairs(property);
    std::erase_if(pairs, [](const Pair& p) { return std::min(p.l.z, p.v.z) < 1e-3f; });
    if (pairs.empty() || table) continue;
    std::array<double, 6> peak;
    peak.fill(1e-3);  // what is darker nobody sees
    for (const Pair& pair : pairs)
      for (const glm::dvec3& v : {glm::dvec3(pair.v), glm::dvec3(-pair.l.x, -pair.l.y, pair.l.z)}) {
        const auto value = in_double(in, pair.l, v);
        for (std::size_t c = 0; c < 6; ++c) peak[c] = std::max(peak[c], value[c]);
      }
    const double share = 2e-5 * std::max(1.0, std::sqrt(sharpness(model.named) / 1000));
    const auto batch = span_of(pairs).evaluate(in);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto exact = in_double(in, pairs[i].l, pairs[i].v);
      const auto single = in_float(in, pairs[i].l, pairs[i].v);
      for (std::size_t c = 0; c < 6; ++c) {
        const double error = std::max(std::abs(double(single[c]) - exact[c]),
                                      std::abs(double(batch[i][c]) - exact[c]));
        double allowed = share * peak[c];
        if (error > allowed) allowed += 8 * conditioning(in, pairs[i], c);
        property.measure(error / allowed, words(model.specification, pairs[i]), ": ", exact[c]);
        EXPECT_LE(error, allowed) << words(model.specification, pairs[i]) << ", channel " << c
                                  << ": " << exact[c] << ", float " << single[c] << ", Batch "
                                  << batch[i][c] << ", peak " << peak[c];
      }
    }
  }
}

}  // namespace
}  // namespace scanlit::stress
