// The bounds that every model's formula gives hold its values: normal, light and viewer move, and
// what the model says on the way stays between the bounds and near a straight line.
#include <rapidcheck.h>

#include <glm/geometric.hpp>
#include <optional>
#include <random>

#include "rasterizer/bounded_directions.h"
#include "tests/unit/test_scene.h"
#include "tests/unit/tested_models.h"

namespace scanlit {
namespace {

using namespace test;

/// A vector that moves for t from -1 to 1.
struct MovingVector {
  glm::dvec3 centre, velocity, acceleration;

  glm::dvec3 direction(double t) const {
    return glm::normalize(centre + velocity * t + acceleration * (t * t / 2));
  }
};

BoundedVector bounded(const std::vector<MovingVector>& lanes) {
  float a[9][max_lanes];
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const auto& [x, v, bend] = lanes[i];
    for (int c = 0; c < 3; ++c) a[c][i] = float(x[c]), a[3 + c][i] = float(v[c]);
    a[6][i] = float(1.000001 * (glm::length(v) + glm::length(bend) / 2) + 1e-7);
    a[7][i] = float(1.000001 * glm::length(bend));
  }
  const auto at = [&](int k) { return Batch::load(a[k]); };
  return {.centre = {at(0), at(1), at(2)},
          .radius = at(6),
          .velocity = {at(3), at(4), at(5)},
          .unsteadiness = at(7),
          .acceleration = at(7)};
}

struct Motion3 {
  MovingVector n, l, v;
};

/// As a triangle sees it: it turns or moves by up to 10^-4 to 1/3 of its distance.
Motion3 random_motion(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto moving = [&](const glm::dvec3& centre) {
    const double size = std::pow(10.0, -4 * unit(random)) / 3;
    const double bent = unit(random) < .5 ? 0 : size * size * unit(random);
    const double speed = unit(random) < .2 ? 0 : size * unit(random);
    return MovingVector{centre, speed * direction(random), bent * direction(random)};
  };
  const glm::dvec3 n = direction(random), v = direction(random);
  const double nearness = std::pow(10.0, -4 * unit(random));  // to the mirror direction
  const glm::dvec3 mirrored = 2 * glm::dot(n, v) * n - v + nearness * direction(random);
  const bool lobe = unit(random) < .5;
  return {moving(n), moving(lobe ? glm::normalize(mirrored) : direction(random)), moving(v)};
}

/// In a shading frame whose normal is n.
glm::dvec3 seen_from(const glm::dvec3& n, const glm::dvec3& d) {
  const glm::dvec3 t =
      glm::normalize(glm::cross(n, std::abs(n.x) < .5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  return {glm::dot(t, d), glm::dot(glm::cross(n, t), d), glm::dot(n, d)};
}

/// The model at time t; nothing where light or viewer are not above the horizon.
std::optional<std::array<double, 6>> value_at(const ReflectionModel& model, const Motion3& m,
                                              double t) {
  const glm::dvec3 n = m.n.direction(t), l = seen_from(n, m.l.direction(t)),
                   v = seen_from(n, m.v.direction(t));
  if (!(l.z > 0) || !(v.z > min_n_v)) return {};
  return in_double(model, l, v);
}

std::array<Bounded, 6> parts(const Reflection<Bounded>& r) {
  return {r.diffuse.r, r.diffuse.g, r.diffuse.b, r.glossy.r, r.glossy.g, r.glossy.b};
}

std::array<float, Batch::lanes> lanes_of(const Batch& batch) {
  std::array<float, Batch::lanes> lanes;
  batch.store(lanes.data());
  return lanes;
}

struct Tally {
  int bent = 0, known = 0, of = 0;  // a curvature is known; something is
};

void require_bounds(const ReflectionModel& model, std::mt19937& random, Tally& tally) {
  std::vector<Motion3> motions;
  std::vector<MovingVector> n, l, v;
  for (int i = 0; i < Batch::lanes; ++i) {
    const Motion3 m = random_motion(random);
    motions.push_back(m), n.push_back(m.n), l.push_back(m.l), v.push_back(m.v);
  }
  BoundedReflection out;
  const BoundedCosines in{
      cosines(direction(bounded(n)), direction(bounded(l)), direction(bounded(v)))};
  if (!model.bounds(in, out)) return;
  std::uniform_real_distribution<double> unit(0, 1);
  const double h = std::pow(10.0, -2 * unit(random)), middle = unit(random);
  const double a = -1 + (2 - h) * unit(random), b = a + h, m = a + middle * h;
  for (std::size_t part = 0; part < 6; ++part) {
    const Bounded bounds = parts(out.value)[part];
    const auto lo = lanes_of(bounds.lo), hi = lanes_of(bounds.hi),
               curvature = lanes_of(bounds.curvature),
               missed = lanes_of(missed_by(bounds, float(h * 1.000001)));
    for (std::size_t i = 0; i < lo.size(); ++i) {
      ++tally.of;
      if (std::isnan(missed[i])) continue;  // nothing is known
      const auto f_a = value_at(model, motions[i], a), f_b = value_at(model, motions[i], b),
                 f_m = value_at(model, motions[i], m);
      if (!f_a || !f_b || !f_m) continue;
      ++tally.known, tally.bent += curvature[i] < 1e30f;
      const double x = (*f_a)[part], y = (*f_m)[part], z = (*f_b)[part];
      RC_ASSERT(double(lo[i]) <= std::min({x, y, z}));
      RC_ASSERT(double(hi[i]) >= std::max({x, y, z}));
      const double rounding = 1e-12 * std::max({1.0, std::abs(x), std::abs(z)});
      RC_ASSERT(std::abs(y - (x + middle * (z - x))) <= double(missed[i]) + rounding);
    }
  }
}

class ModelBounds : public testing::TestWithParam<std::string> {};

TEST_P(ModelBounds, HoldItsValues) {
  for (const std::string& specification : tested(GetParam()).specifications) {
    const auto model = models::make(specification).model;
    Tally tally;
    EXPECT_TRUE(holds(20, [&] {
      std::mt19937 random(*rc::gen::arbitrary<unsigned>());
      require_bounds(*model, random, tally);
    })) << specification;
    // Where anything is known, it is of most directions, and not only an interval.
    EXPECT_GE(tally.known, tally.of / 4) << specification;
    EXPECT_GE(tally.bent, tally.known / 3) << specification;
  }
}

TEST(ModelBounds, AreUnknownWhereTangentsMatter) {
  BoundedReflection out;
  const BoundedDirection up{.centre = {Batch(0), Batch(0), Batch(1)}};
  const BoundedCosines in{cosines(up, up, up)};
  EXPECT_TRUE(models::make("cook-torrance").model->bounds(in, out));
  EXPECT_FALSE(models::make("cook-torrance:D=anisotropic-ggx").model->bounds(in, out));
  EXPECT_FALSE(models::make("ward").model->bounds(in, out));
  EXPECT_FALSE(models::make("lambert:kd=vertex-colour").model->bounds(in, out));
  EXPECT_TRUE(models::make("sum:(lambert),.5*(phong)").model->bounds(in, out));
  EXPECT_FALSE(models::make("sum:(lambert),(ward)").model->bounds(in, out));
}

// Sharper than what a model makes of it: of each term of the bounds something would be missed.
TEST(BoundedCosine, HoldsHowFastTheAngleChanges) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 5000; ++round) {
    std::vector<MovingVector> a, b;
    for (int i = 0; i < Batch::lanes; ++i) {
      const Motion3 m = random_motion(random);
      a.push_back(m.n), b.push_back(m.l);
      // Also where both move alike, where one stands, and straight across the plane of both.
      if (i % 4 == 0) b.back().velocity = a.back().velocity;
      if (i % 4 == 1) b.back().velocity = glm::dvec3(0);
      if (i % 4 == 2)
        a.back().velocity = glm::length(a.back().velocity) *
                            glm::normalize(glm::cross(a.back().centre, b.back().centre));
    }
    const Bounded bounds = cosine(direction(bounded(a)), direction(bounded(b))).cos;
    const auto slope = lanes_of(bounds.slope), curvature = lanes_of(bounds.curvature);
    const double t = -1 + 2 * unit(random), h = 1e-3;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::isnan(slope[i])) continue;
      const auto at = [&](double time) {
        return glm::dot(a[i].direction(time), b[i].direction(time));
      };
      const double before = at(t - h), here = at(t), after = at(t + h);
      const double slack = double(Bounded::rounding_slack);
      ASSERT_LE(std::abs(after - before) / (2 * h), double(slope[i]) * slack + 1e-12);
      ASSERT_LE(std::abs(before - 2 * here + after) / (h * h), double(curvature[i]) * slack + 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ModelBounds, testing::ValuesIn(all_names()), word);

}  // namespace
}  // namespace scanlit
