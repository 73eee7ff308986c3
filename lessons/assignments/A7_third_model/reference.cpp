#include "lessons/assignments/A7_third_model/reference.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "lessons/assignments/judge/dice.h"

namespace scanlit::assignments::third_model {

using std::numbers::pi;

Variant::Variant(std::uint64_t seed) {
  Dice dice(seed, "A7");
  const auto drawn = [&dice](double least, double most) {
    return dice.between(int(std::lround(100 * least)), int(std::lround(100 * most))) / 100.0;
  };
  const auto colour = [&](double least, double most) {
    const double r = drawn(least, most), g = drawn(least, most);
    return Values{r, g, drawn(least, most)};
  };
  braces = dice.coin();
  angles = dice.coin();
  ax = angles ? dice.between(6, 10) : drawn(.07, .12);
  ay = angles ? dice.between(20, 26) : drawn(.25, .35);
  normalisation = dice.between(0, 2);
  ward_rho = {drawn(.5, .7), drawn(.4, .55), drawn(.2, .35)};
  lafortune_diffuse = {drawn(.1, .2), drawn(.2, .3), drawn(.35, .5)};
  for (int lobe = 0; lobe < 2; ++lobe) {
    // The first leaves more upright than a mirror would have it, the second goes back to the light.
    const double sign = lobe == 0 ? -1 : 1;
    for (int axis = 0; axis < 2; ++axis) {
      lobes[lobe][axis] = colour(.45, .6);
      for (double& c : lobes[lobe][axis]) c *= sign;
    }
    lobes[lobe][1] = lobes[lobe][0];
    lobes[lobe][2] = colour(lobe == 0 ? .62 : .35, lobe == 0 ? .72 : .45);
    const int n = dice.between(6, 12);
    lobes[lobe][3] = Values{double(n), double(n + 1), double(n + 2)};
  }
  degrees = dice.coin();
  roughness = degrees ? dice.between(20, 40) : drawn(.35, .8);
  constant = dice.coin() ? .33 : .57;
  oren_rho = {drawn(.7, .9), drawn(.6, .8), drawn(.5, .7)};
}

namespace {

class Ward final : public Model {
 public:
  explicit Ward(const Variant& variant) : variant_(variant) {}

  Values first(const Directions& d) const override {
    return exponential(d, width(variant_.ax), width(variant_.ay), 1);
  }
  Values second(const Values& first, const Directions& d) const override {
    const Vec3<double> h = d.l + d.v;
    const double a = width(variant_.ax) * width(variant_.ay), cosines = d.l.z * d.v.z;
    const double scale = variant_.normalisation == 0   ? 1 / (4 * pi * a * std::sqrt(cosines))
                         : variant_.normalisation == 1 ? 1 / (4 * pi * a * cosines)
                                                       : dot(h, h) / (pi * a * std::pow(h.z, 4));
    Values f = variant_.ward_rho;
    for (std::size_t i = 0; i < 3; ++i) f[i] *= scale * first[i];
    return f;
  }
  std::vector<Mistake> mistakes_of_first() const override {
    const double ax = width(variant_.ax), ay = width(variant_.ay);
    const auto with = [](double x, double y, double factor) {
      return [=](const Directions& d) { return exponential(d, x, y, factor); };
    };
    return {
        {with(ay, ax, 1), .4, "ax and ay are exchanged."},
        {with(ax, ax, 1), .4, "ax stands in both places: the surface is isotropic."},
        {with(std::sqrt(ax), std::sqrt(ay), 1), .4, "The squares of ax and ay are missing."},
        {with(ax, ay, .5), .4, "The exponent is half of what it should be."},
        {with(variant_.ax, variant_.ay, 1), .4, "It is not ax and ay themselves that are given."},
        {with(ax, ay, -1), .4, "The exponent has the wrong sign."},
        {[ax, ay](const Directions& d) {
           const Vec3<double> h = d.frame().h;
           return Values(3, std::exp(-(std::pow(h.x / ax, 2) + std::pow(h.y / ay, 2))));
         },
         .4, "The division by hz^2 is missing."}};
  }

 private:
  double width(double given) const {
    return variant_.angles ? std::tan(given * pi / 180) : std::numbers::sqrt2 * given;
  }
  static Values exponential(const Directions& d, double ax, double ay, double factor) {
    const Vec3<double> h = d.l + d.v;
    return Values(
        3, std::exp(-factor * (std::pow(h.x / ax, 2) + std::pow(h.y / ay, 2)) / (h.z * h.z)));
  }
  Variant variant_;
};

class Lafortune final : public Model {
 public:
  explicit Lafortune(const Variant& variant) : variant_(variant) {}

  Values first(const Directions& d) const override { return lobe(0, d, 1, 1, false); }
  Values second(const Values& first, const Directions& d) const override {
    Values f = lobe(1, d, 1, 1, false);
    for (std::size_t i = 0; i < 3; ++i) f[i] += first[i] + variant_.lafortune_diffuse[i] / pi;
    return f;
  }
  std::vector<Mistake> mistakes_of_first() const override {
    const auto with = [this](double sign, double power, bool late) {
      return
          [*this, sign, power, late](const Directions& d) { return lobe(0, d, sign, power, late); };
    };
    return {{with(-1, 1, false), .4,
             "The signs of Cx and Cy are lost: this lobe goes back to the light."},
            {with(1, .5, false), .4, "The exponent is half of what it should be."},
            {with(1, 2, false), .4, "The exponent is twice what it should be."},
            {with(1, 1, true), .4,
             "A negative sum is raised to a power: clamp first, then the power."}};
  }

 private:
  Values lobe(int i, const Directions& d, double sign, double power, bool late) const {
    Values all;
    for (std::size_t c = 0; c < 3; ++c) {
      const Values(&lobe)[4] = variant_.lobes[i];
      const double sum = sign * (lobe[0][c] * d.l.x * d.v.x + lobe[1][c] * d.l.y * d.v.y) +
                         lobe[2][c] * d.l.z * d.v.z;
      all.push_back(std::pow(late ? sum : std::max(0., sum), power * lobe[3][c]));
    }
    return all;
  }
  Variant variant_;
};

class OrenNayar final : public Model {
 public:
  explicit OrenNayar(const Variant& variant) : variant_(variant) {}

  Values first(const Directions& d) const override { return groove(d, std::less<>(), true); }
  Values second(const Values& first, const Directions& d) const override {
    (void)d;
    const double given = variant_.roughness;
    const double sigma = variant_.degrees ? given * pi / 180 : std::atan(given), s2 = sigma * sigma;
    Values f = variant_.oren_rho;
    for (std::size_t i = 0; i < 3; ++i)
      f[i] *= (1 - .5 * s2 / (s2 + variant_.constant) + .45 * s2 / (s2 + .09) * first[i]) / pi;
    return f;
  }
  std::vector<Mistake> mistakes_of_first() const override {
    return {
        {[](const Directions& d) { return groove(d, std::greater<>(), true); }, .4,
         "A and B are exchanged: A is the larger of the two angles."},
        {[](const Directions& d) { return groove(d, std::less<>(), false); }, .4,
         "cos phi below 0 is not clamped: max(0, cos phi)."},
        {[](const Directions& d) { return Values(3, std::max(0., d.l.x * d.v.x + d.l.y * d.v.y)); },
         .4, "That is sin A sin B: the division by cos B is missing."}};
  }

 private:
  /// cos phi sin A tan B = cos phi sin A sin B / cos B; the smaller angle has the larger cosine.
  template <class Less>
  static Values groove(const Directions& d, Less less, bool clamped) {
    const double along = d.l.x * d.v.x + d.l.y * d.v.y;
    const double cos_b = less(d.l.z, d.v.z) ? d.v.z : d.l.z;
    return Values(3, (clamped ? std::max(0., along) : along) / cos_b);
  }
  Variant variant_;
};

}  // namespace

std::unique_ptr<Model> Variant::model(int choice) const {
  if (choice == 2) return std::make_unique<Lafortune>(*this);
  if (choice == 3) return std::make_unique<OrenNayar>(*this);
  return std::make_unique<Ward>(*this);
}

Values Variant::returned(Values f_r, const Directions& d) const {
  for (double& value : f_r) value *= braces ? pi * d.l.z : 1;
  return f_r;
}

}  // namespace scanlit::assignments::third_model
