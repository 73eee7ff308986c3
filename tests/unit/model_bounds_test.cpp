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
  MovingVector n, l, v, brushed;
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
  return {moving(n), moving(lobe ? glm::normalize(mirrored) : direction(random)), moving(v),
          moving(direction(random))};
}

/// In the shading frame of normal n.
glm::dvec3 seen_from(const glm::dvec3& n, const glm::dvec3& brushed, const glm::dvec3& d) {
  const glm::dvec3 t = glm::normalize(brushed - glm::dot(brushed, n) * n);
  return {glm::dot(t, d), glm::dot(glm::cross(n, t), d), glm::dot(n, d)};
}

/// The model at time t; nothing where light or viewer are not above the horizon.
std::optional<std::array<double, 6>> value_at(const ReflectionModel& model, const Motion3& m,
                                              double t) {
  const glm::dvec3 n = m.n.direction(t), brushed = m.brushed.direction(t),
                   l = seen_from(n, brushed, m.l.direction(t)),
                   v = seen_from(n, brushed, m.v.direction(t));
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
  std::vector<MovingVector> moving[4];
  for (int i = 0; i < Batch::lanes; ++i) {
    const Motion3 m = random_motion(random);
    motions.push_back(m);
    moving[0].push_back(m.n), moving[1].push_back(m.l), moving[2].push_back(m.v);
    moving[3].push_back(m.brushed);
  }
  BoundedReflection out;
  const BoundedDirection n = direction(bounded(moving[0])), l = direction(bounded(moving[1])),
                         v = direction(bounded(moving[2])), brushed = direction(bounded(moving[3]));
  const BoundedAxes axes(n, brushed);
  const BoundedCosines in{cosines(n, l, v), &axes, l, v};
  if (!model.bounds(in, out)) return;
  std::uniform_real_distribution<double> unit(0, 1);
  const double h = std::pow(10.0, -2 * unit(random)), middle = unit(random);
  const double a = -1 + (2 - h) * unit(random), b = a + h, m = a + middle * h;
  for (std::size_t part = 0; part < 6; ++part) {
    const Bounded bounds = parts(out.value)[part];
    const auto lo = lanes_of(bounds.lo), hi = lanes_of(bounds.hi),
               curvature = lanes_of(bounds.curvature),
               missed = lanes_of(missed_by(bounds, Spacing::of(float(h * 1.000001))));
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

// The normal turns through a lobe, H and the tangents at rest: the second derivative is bounded,
// and nowhere by much more than it is at most.
TEST(ModelBounds, AreSharpInALobe) {
  constexpr double reach = .01, h = 1e-3;
  const auto in_batch = [](const glm::dvec3& a) -> Vec3<Batch> {
    return {Batch(float(a.x)), Batch(float(a.y)), Batch(float(a.z))};
  };
  for (const std::string specification : {"distribution:m=.3", "distribution:D=gaussian,m=.3",
                                          "distribution:D=ashikhmin-shirley,ex=20,ey=500"}) {
    const auto model = models::make(specification).model;
    double greatest = 0, bound = 0;
    for (double angle = 0; angle < 1.2; angle += .02) {
      const auto normal = [&](double t) {
        return glm::dvec3(std::sin(angle + t), 0, std::cos(angle + t));
      };
      const glm::dvec3 up(0, 0, 1), brushed(0, 1, 0);
      const BoundedDirection n = direction({.centre = in_batch(normal(0)),
                                            .radius = Batch(1.001f * float(reach)),
                                            .velocity = in_batch(normal(std::acos(0.0))),
                                            .unsteadiness = Batch(1.001f * float(reach)),
                                            .acceleration = Batch(1)});
      const BoundedDirection l{.centre = in_batch(up)};
      const BoundedAxes axes(n, {.centre = in_batch(brushed)});
      BoundedReflection out;
      ASSERT_TRUE(model->bounds({cosines(n, l, l), &axes, l, l}, out));
      const auto value = [&](double t) {
        const glm::dvec3 d = seen_from(normal(t), brushed, up);
        return in_double(*model, d, d)[3];
      };
      for (const double t : {-reach + h, 0.0, reach - h}) {
        const double bent = std::abs(value(t - h) - 2 * value(t) + value(t + h)) / (h * h);
        const double at_most = double(lanes_of(out.value.glossy.r.curvature)[0]);
        EXPECT_LE(bent, 1.001 * at_most + 1e-6) << specification << ", angle " << angle + t;
        greatest = std::max(greatest, bent), bound = std::max(bound, at_most);
      }
    }
    EXPECT_LT(bound, 4 * greatest) << specification;
  }
}

TEST(ModelBounds, AreUnknownWhereTangentsMatterAndAreNotKnown) {
  BoundedReflection out;
  const BoundedDirection up{.centre = {Batch(0), Batch(0), Batch(1)}};
  const BoundedCosines in{cosines(up, up, up)};
  EXPECT_TRUE(models::make("cook-torrance").model->bounds(in, out));
  EXPECT_FALSE(models::make("cook-torrance:D=anisotropic-ggx").model->bounds(in, out));
  EXPECT_FALSE(models::make("ward").model->bounds(in, out));
  const BoundedAxes axes(up, BoundedDirection{.centre = {Batch(1), Batch(0), Batch(0)}});
  const BoundedCosines framed{in.cosines, &axes, up, up};
  EXPECT_TRUE(models::make("sum:(lambert),(ward)").model->bounds(framed, out));
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
