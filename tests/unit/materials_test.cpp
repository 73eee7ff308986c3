// Materials by name: each is a model that can be made, reflects no more light than it gets, and has
// a source; what is given besides the name takes the place of its own values.
#include "models/materials.h"

#include <cmath>
#include <numbers>
#include <set>

#include "models/albedo.h"
#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;
using models::NamedMaterial;

std::string named(const NamedMaterial& material) { return "material:" + material.name; }

glm::dvec3 seen_at(double theta_deg) {
  return at(std::cos(theta_deg * std::numbers::pi / 180), 0.7);
}

TEST(Materials, AreWhatTheySay) {
  std::set<std::string> names;
  for (const NamedMaterial& material : models::materials()) {
    EXPECT_TRUE(names.insert(material.name).second) << material.name << " is there twice";
    EXPECT_FALSE(material.source.empty()) << material.name;
    const auto by_name = models::make(named(material)),
               by_text = models::make(material.specification);
    EXPECT_EQ(by_name.specification, named(material));
    EXPECT_EQ(by_name.tangents.has_value(), material.tangents.has_value());
    for (const double theta_deg : {0.0, 40.0, 80.0}) {
      const glm::dvec3 l = at(0.8, 2), v = seen_at(theta_deg);
      EXPECT_EQ(in_double(*by_name.model, l, v), in_double(*by_text.model, l, v)) << material.name;
    }
  }
  for (const char* name : {"copper", "gold", "silver", "porcelain", "velvet", "blue-house-paint"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Materials, ReflectAtMostWhatTheyGet) {
  for (const NamedMaterial& material : models::materials()) {
    const auto model = models::make(named(material)).model;
    for (const double theta_deg : {0.0, 60.0, 80.0, 88.0}) {
      const glm::dvec3 v = seen_at(theta_deg);
      const auto albedo = models::directional_albedo(*model, {v.x, v.y, v.z}, 1e-3, 200000).value;
      EXPECT_LE(std::max({albedo.r, albedo.g, albedo.b}), 1 + 1e-3)
          << material.name << ' ' << theta_deg;
    }
  }
}

TEST(Materials, AreReciprocal) {
  std::mt19937 random(1);
  for (const NamedMaterial& material : models::materials()) {
    const auto model = models::make(named(material)).model;
    for (int round = 0; round < 300; ++round) {
      glm::dvec3 l = direction(random), v = direction(random);
      l.z = std::abs(l.z), v.z = std::abs(v.z);
      if (std::min(l.z, v.z) < min_n_v) continue;
      const auto one = in_double(*model, l, v), other = in_double(*model, v, l);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR((one[c] + one[3 + c]) * v.z, (other[c] + other[3 + c]) * l.z, 1e-9)
            << material.name;
    }
  }
}

TEST(Materials, ValuesInPlaceOfTheirOwn) {
  const glm::dvec3 l = at(0.8, 2), v = at(0.7, -1);
  const auto value = [&](const char* specification) {
    return in_double(*models::make(specification).model, l, v);
  };
  EXPECT_EQ(value("material:copper,m=.2"), value("cook-torrance:F=copper,m=.2"));
  EXPECT_EQ(value("material:copper,m=.2,kd=.1"), value("cook-torrance:F=copper,m=.2,kd=.1"));
  EXPECT_EQ(value("material:porcelain,base=(lambert:kd=.2)"),
            value("clear-coat:base=(lambert:kd=.2),a=.06"));
  EXPECT_EQ(value("material:velvet,rd=.1,lobe=(n=3)"), value("lafortune:rd=.1,lobe=(n=3)"));
  EXPECT_NE(value("material:copper,m=.2"), value("material:copper"));
  ASSERT_TRUE(models::make("material:brushed-aluminium").tangents);
  EXPECT_EQ(models::make("material:brushed-aluminium").tangents->field, TangentField::around);
}

TEST(Materials, Refusals) {
  EXPECT_EQ(error_of("material:coper"), "unknown material 'coper'; did you mean 'copper'?");
  EXPECT_TRUE(error_of("material").starts_with("unknown material ''; there are: "));
  EXPECT_TRUE(error_of("material:m=.2").starts_with("unknown material ''; there are: "));
  EXPECT_EQ(error_of("material:copper,m=.2,m=.3"), "model 'cook-torrance': 'm' is given twice");
  EXPECT_EQ(error_of("material:copper,m=2"),
            "model 'cook-torrance': 'm' wants a number from 0.001 to 1, not 2");
  EXPECT_EQ(error_of("material:copper,.2"),
            "model 'material': expected key=value after 'copper', not '.2'");
}

}  // namespace
}  // namespace scanlit
