#include "lessons/assignments/judge/model_questions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lessons/assignments/judge/dice.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments {

namespace {

using std::numbers::pi;

constexpr double degrees = 180 / pi;

struct Ratio {
  double (*value)(const Cosines<double>&);
  const char* meaning;
};

/// What got / expected may be at every pair, and what that says.
constexpr std::array ratios{
    Ratio{[](const auto&) { return pi; }, "pi times too large: is 1/pi forgotten?"},
    Ratio{[](const auto&) { return 1 / pi; }, "pi times too small: is there a 1/pi too many?"},
    Ratio{[](const auto&) { return pi * pi; }, "pi^2 times too large."},
    Ratio{[](const auto&) { return 4 / pi; }, "4/pi times too large: 1/pi where 1/4 belongs?"},
    Ratio{[](const auto&) { return 4.0; }, "4 times too large: is 1/4 forgotten?"},
    Ratio{[](const auto&) { return .25; }, "4 times too small: is there a 1/4 too many?"},
    Ratio{[](const auto&) { return 2.0; }, "2 times too large."},
    Ratio{[](const auto&) { return .5; }, "2 times too small."},
    Ratio{[](const auto&) { return -1.0; }, "of the wrong sign."},
    Ratio{[](const auto& c) { return c.n_l; },
          "N.L times what it should be: one factor N.L too many."},
    Ratio{[](const auto& c) { return 1 / c.n_l; }, "too large by 1 / (N.L): N.L is missing."},
    Ratio{[](const auto& c) { return c.n_v; },
          "N.V times what it should be: one factor N.V too many."},
    Ratio{[](const auto& c) { return 1 / c.n_v; }, "too large by 1 / (N.V): N.V is missing."},
    Ratio{[](const auto& c) { return c.n_h.cos; },
          "N.H times what it should be: one N.H too many."},
    Ratio{[](const auto& c) { return 1 / c.n_h.cos; }, "too large by 1 / (N.H): N.H is missing."},
    Ratio{[](const auto& c) { return c.n_v / c.n_l; }, "N.L and N.V are exchanged."},
    Ratio{[](const auto& c) { return c.n_l / c.n_v; }, "N.L and N.V are exchanged."},
    Ratio{[](const auto& c) { return pi * c.n_l; }, "pi (N.L) times too large."},
    Ratio{[](const auto& c) { return 1 / (pi * c.n_l); }, "pi (N.L) times too small."},
};

/// Of the values that are right, the largest: what is small beside it need not be right to 4
/// digits.
double scale_of(const Values& expected) {
  double largest = 0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  return largest;
}

Values all_rows(const Asked& asked, const std::function<Values(const Directions&)>& formula) {
  Values all;
  for (const Directions& d : asked.directions)
    for (const double value : formula(d)) all.push_back(value);
  return all;
}

bool all_agree(const Values& a, const Values& b, double scale) {
  return std::ranges::equal(a, b, [&](double x, double y) { return agree(x, y, scale); });
}

}  // namespace

Vec3<double> direction(double theta_deg, double phi_deg) {
  const double theta = theta_deg / degrees, phi = phi_deg / degrees;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

std::vector<Directions> seeded_directions(std::uint64_t seed, int count) {
  Dice dice(seed, "directions");
  std::vector<Directions> all;
  for (int i = 0; i < count; ++i) {
    double theta_l = dice.real(2, 80), theta_v = dice.real(2, 80);
    double phi_l = dice.real(0, 360), phi_v = dice.real(0, 360);
    if (i % 4 == 1) {
      phi_v = phi_l + 180 + dice.real(-12, 12);
      theta_v = std::clamp(theta_l + dice.real(-12, 12), 1., 80.);
    }
    if (i % 4 == 2) theta_l = dice.real(80, 89);
    if (i % 4 == 3) theta_v = dice.real(80, 89), phi_v = phi_l + 180 + dice.real(-30, 30);
    all.push_back({direction(theta_l, phi_l), direction(theta_v, phi_v)});
  }
  return all;
}

Values received(Numbers answer) {
  for (std::size_t i = 0; i < answer.reals.size(); ++i)
    if (answer.integers[i] != 0)
      answer.reals[i] = answer.integers[i] == 1 ? std::numeric_limits<double>::quiet_NaN()
                                                : std::numeric_limits<double>::infinity();
  return answer.reals;
}

Values ask_values(Respondent& student, const Asked& asked) {
  Numbers question{.integers = {std::int64_t(asked.directions.size())}, .reals = {}};
  for (const Directions& d : asked.directions) {
    for (const Vec3<double>& w : {d.l, d.v})
      question.reals.insert(question.reals.end(), {w.x, w.y, w.z});
    if (asked.given)
      for (const double value : asked.given(d)) question.reals.push_back(value);
  }
  const std::size_t count = asked.directions.size() * std::size_t(asked.width);
  return received(student.ask(asked.kind, question, {count, count, count, count}));
}

double ask_number(Respondent& student, int kind) {
  return received(student.ask(kind, {}, {1, 1, 1, 1}))[0];
}

bool agree(double a, double b, double scale) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= 1e-4 * std::max(std::abs(b), 1e-4 * scale);
}

std::string describe(const Directions& d) {
  const Cosines<double> c = d.cosines();
  double between = (std::atan2(d.v.y, d.v.x) - std::atan2(d.l.y, d.l.x)) * degrees;
  between = std::abs(std::remainder(between, 360));
  return worded(
      "L at %.1f degrees from N, V at %.1f, %.1f about N between them:\n  N.L = %.4f, N.V = %.4f, "
      "N.H = %.4f, V.H = %.4f",
      std::acos(c.n_l) * degrees, std::acos(c.n_v) * degrees, between, c.n_l, c.n_v, c.n_h.cos,
      c.v_h);
}

std::string describe(const Values& row) {
  std::string text;
  for (const double value : row)
    text += (text.empty() ? "" : ", ") + (std::isnan(value)   ? "NaN"
                                          : std::isinf(value) ? "an infinity"
                                                              : worded("%.6g", value));
  return row.size() == 1 ? text : "(" + text + ")";
}

Finding compare_rows(const Rows& rows, const std::vector<WrongRows>& mistakes) {
  const Values &got = rows.got, &expected = rows.expected;
  const double scale = scale_of(expected);
  const auto width = std::size_t(rows.width), count = expected.size() / width;
  // Tiny values say little, though they be the first: of two that are as wrong, the larger is
  // shown.
  constexpr double for_size = .1;
  std::size_t wrong = 0, worst = 0;
  double most_off = -1;
  for (std::size_t i = 0; i < count; ++i) {
    bool right = true;
    double off = 0;
    for (std::size_t k = i * width; k < (i + 1) * width; ++k) {
      right &= agree(got[k], expected[k], scale);
      off = std::isfinite(got[k])
                ? std::max(off, std::abs(got[k] - expected[k]) + for_size * std::abs(expected[k]))
                : std::numeric_limits<double>::infinity();
    }
    wrong += !right;
    if (!right && off > most_off) most_off = off, worst = i;
  }
  if (wrong == 0) return {};

  const auto row = [&](const Values& all) {
    const auto at = all.begin() + std::ptrdiff_t(worst * width);
    return describe(Values(at, at + std::ptrdiff_t(width)));
  };
  const auto finding = [&](double share, const std::string& hint) -> Finding {
    return {share, worded("%s is wrong at %zu of %zu %s. The worst:\n  %s\n  yours:     %s\n"
                          "  should be: %s",
                          rows.name.c_str(), wrong, count, rows.of_what.c_str(),
                          rows.describe(worst).c_str(), row(got).c_str(), row(expected).c_str()) +
                       (hint.empty() ? "" : "\n" + hint)};
  };
  if (std::ranges::all_of(got, [](double value) { return value == 0; }))
    return finding(0, "It is 0 everywhere.");
  for (const WrongRows& mistake : mistakes)
    if (all_agree(got, mistake.values, scale)) return finding(mistake.share, mistake.message);
  const double factor = got[0] / expected[0];
  Values scaled = expected;
  for (double& value : scaled) value *= factor;
  if (std::isfinite(factor) && factor != 0 && all_agree(got, scaled, scale_of(scaled)))
    return finding(.25, worded("Everywhere it is %.5g times what it should be.", factor));
  if (std::ranges::any_of(got, [](double value) { return std::isnan(value); }))
    return finding(0, "NaN is what 0/0 gives, and a root or power of a negative number.");
  return finding(0, "");
}

Finding compare_values(Examination& e, const Asked& asked, const std::vector<Mistake>& mistakes) {
  const Rows rows{.name = asked.name,
                  .width = asked.width,
                  .expected = all_rows(asked, asked.reference),
                  .got = ask_values(e.student, asked),
                  .of_what = "pairs of directions",
                  .describe = [&](std::size_t i) { return describe(asked.directions[i]); }};
  std::vector<WrongRows> wrong;
  for (const Mistake& mistake : mistakes)
    wrong.push_back({all_rows(asked, mistake.value), mistake.share, mistake.message});
  for (const Ratio& ratio : ratios) {
    Values values = rows.expected;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] *= ratio.value(asked.directions[i / std::size_t(asked.width)].cosines());
    wrong.push_back({values, .25, worded("Everywhere it is %s", ratio.meaning)});
  }
  return compare_rows(rows, wrong);
}

Finding combine(const std::vector<std::pair<double, Finding>>& weighted) {
  Finding all{0, ""};
  double sum = 0;
  for (const auto& [weight, finding] : weighted) {
    all.share += weight * finding.share, sum += weight;
    if (!finding.message.empty())
      all.message += (all.message.empty() ? "" : "\n") + finding.message;
  }
  all.share /= sum;
  return all;
}

}  // namespace scanlit::assignments
