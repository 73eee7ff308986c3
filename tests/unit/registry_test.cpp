// From text to a model: specifications, and the exact words of every refusal.
#include "models/registry.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <set>

#include "models/lambert.h"
#include "tests/unit/tested_models.h"

namespace scanlit::models {
namespace {

using test::error_of;

/// The value a parameter has got.
Rgb<double> value_of(std::string_view specification, const std::string& key) {
  for (const auto& [name, value] : make(specification).values)
    if (name == key) return colour_of(value);
  ADD_FAILURE() << "no parameter " << key;
  return {};
}

TEST(Registry, ListsEveryModelWithWhatThereIsToKnow) {
  std::set<std::string> names;
  for (const ModelInfo& info : list()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " is there twice";
    EXPECT_FALSE(info.title.empty() || info.source.empty()) << info.name;
    std::set<std::string> keys;
    for (const ParameterInfo& p : info.parameters) {
      EXPECT_TRUE(keys.insert(p.key).second) << info.name << ' ' << p.key;
      EXPECT_FALSE(p.meaning.empty()) << info.name << ' ' << p.key;
      if (p.kind != ParameterKind::number && p.kind != ParameterKind::colour) continue;
      EXPECT_LT(p.min, p.max) << info.name << ' ' << p.key;
      const Rgb<double> initial = colour_of(p.initial);
      for (const double channel : {initial.r, initial.g, initial.b})
        EXPECT_TRUE(channel >= p.min && channel <= p.max) << info.name << ' ' << p.key;
    }
  }
  for (const char* name : {"lambert", "phong", "blinn-phong"}) EXPECT_TRUE(names.contains(name));
}

TEST(Registry, DefaultsWhereNothingIsSaid) {
  const NamedModel model = make("blinn-phong");
  EXPECT_EQ(model.specification, "blinn-phong");
  ASSERT_NE(model.model, nullptr);
  for (const ModelInfo& info : list()) {
    if (test::wants_file(info) || !info.example.empty()) continue;
    const auto values = make(info.name).values;
    ASSERT_EQ(values.size(), info.parameters.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_EQ(values[i].first, info.parameters[i].key);
      EXPECT_EQ(values[i].second, info.parameters[i].initial);
    }
  }
}

TEST(Registry, OneNumberIsGreyAndThreeAreRgb) {
  EXPECT_EQ(value_of("phong:ks=.25", "ks"), Rgb<double>(0.25));
  EXPECT_EQ(value_of("phong:ks=.1/.2/.3", "ks"), Rgb<double>(0.1, 0.2, 0.3));
  EXPECT_EQ(value_of("phong:n=7,ks=1", "n").r, 7);
  EXPECT_EQ(value_of("phong:n=1e3", "n").r, 1000);
  EXPECT_EQ(value_of("phong:n=7", "kd"), value_of("phong", "kd"));
}

TEST(Registry, RangesIncludeTheirEnds) {
  EXPECT_EQ(value_of("phong:n=0", "n").r, 0);
  EXPECT_EQ(value_of("phong:n=100000", "n").r, 1e5);
  EXPECT_EQ(value_of("phong:kd=0/1/.5", "kd"), Rgb<double>(0, 1, 0.5));
}

TEST(Registry, TheValuesReachTheModel) {
  const auto head_on = [](std::string_view specification) {
    return make(specification).model->evaluate(Vec3<double>{0, 0, 1}, {0, 0, 1});
  };
  EXPECT_EQ(head_on("phong:kd=.1/.2/.3,ks=.5").diffuse, Rgb<double>(0.1, 0.2, 0.3));
  EXPECT_EQ(head_on("phong:kd=.1/.2/.3,ks=.5").glossy, Rgb<double>(0.5));
  EXPECT_EQ(head_on("lambert:kd=.1/.2/.3").glossy, Rgb<double>(0.0));
}

TEST(Registry, UnknownNames) {
  EXPECT_EQ(error_of("blin-phong"), "unknown model 'blin-phong'; did you mean 'blinn-phong'?");
  EXPECT_EQ(error_of("Phong"), "unknown model 'Phong'; did you mean 'phong'?");
  EXPECT_TRUE(error_of("velvet").starts_with("unknown model 'velvet'; there are: "));
  for (const ModelInfo& info : list())
    EXPECT_NE(error_of("velvet").find(info.name), std::string::npos) << info.name;
  EXPECT_TRUE(error_of("").starts_with("unknown model ''; there are: "));
  EXPECT_EQ(error_of("phong:kr=1"), "model 'phong': unknown parameter 'kr'; did you mean 'kd'?");
  EXPECT_EQ(error_of("phong:shininess=1"),
            "model 'phong': unknown parameter 'shininess'; there are: kd, ks, n");
}

TEST(RegistryDeathTest, TwoModelsOfOneName) {
  // In a process of its own, because what is registered stays so; started anew, because a fork
  // would lack the threads that libraries wait for at its end.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto register_another = [] {
    const Registered<Lambert<>> another;
    std::cerr << error_of("lambert");
    std::exit(0);
  };
  EXPECT_EXIT(register_another(), testing::ExitedWithCode(0),
              "model 'lambert': two of them have this name");
}

TEST(Registry, MalformedAssignments) {
  EXPECT_EQ(error_of("phong:"), "model 'phong': expected key=value, not ''");
  EXPECT_EQ(error_of("phong:kd"), "model 'phong': expected key=value, not 'kd'");
  EXPECT_EQ(error_of("phong:=1"), "model 'phong': expected key=value, not '=1'");
  EXPECT_EQ(error_of("phong:kd=1,"), "model 'phong': expected key=value, not ''");
  EXPECT_EQ(error_of("phong:kd=1,kd=.5"), "model 'phong': 'kd' is given twice");
}

TEST(Registry, ValuesThatAreNoneOrOutOfRange) {
  const std::string wants = "model 'phong': 'n' wants a number from 0 to 100000, not ";
  for (const char* text : {"", "many", "1x", " 1", "0x10", "nan", "inf", "1e999", "--1"})
    EXPECT_EQ(error_of(std::string("phong:n=") + text), wants + "'" + text + "'");
  EXPECT_EQ(error_of("phong:n=-1"), wants + "-1");
  EXPECT_EQ(error_of("phong:n=100001"), wants + "100001");
  EXPECT_EQ(error_of("phong:n=1/2/3"), "model 'phong': 'n' wants one number, not '1/2/3'");
  EXPECT_EQ(error_of("phong:kd=1/2"), "model 'phong': 'kd' wants one number or r/g/b, not '1/2'");
  EXPECT_EQ(error_of("phong:kd=.1/.2/1.5"),
            "model 'phong': 'kd' wants a number from 0 to 1, not 1.5");
  EXPECT_EQ(error_of("phong:kd=.1//.2"), "model 'phong': 'kd' wants a number from 0 to 1, not ''");
}

TEST(DidYouMean, NamesTheNearestWhereOneIsNear) {
  const std::vector<std::string> words = {"cube", "sphere", "torus"};
  EXPECT_EQ(did_you_mean("spere", words), "; did you mean 'sphere'?");
  EXPECT_EQ(did_you_mean("shpere", words), "; did you mean 'sphere'?");
  EXPECT_EQ(did_you_mean("tube", words), "; did you mean 'cube'?");
  EXPECT_EQ(did_you_mean("pyramid", words), "; there are: cube, sphere, torus");
  EXPECT_EQ(did_you_mean("", words), "; there are: cube, sphere, torus");
  EXPECT_EQ(did_you_mean("cube", {}), "");
  EXPECT_EQ(did_you_mean(std::string(1000000, 'e'), words), "; there are: cube, sphere, torus")
      << "not compared letter by letter";
}

}  // namespace
}  // namespace scanlit::models
