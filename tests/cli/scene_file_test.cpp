// Scene files: what they say arrives, and what is wrong in them is named with its place.
#include "lessons/studio/scene_file.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

Description read(const std::string& text) { return read_scene(text, "scene.toml"); }

const std::string one_object = "[[object]]\nmesh = 'teapot'\n";

glm::vec3 placed(const std::string& transform, const glm::vec3& point) {
  const Description scene = read(one_object + transform);
  return glm::vec3(scene.objects.front().world_from_object * glm::vec4(point, 1));
}

void expect_near(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(SceneFile, AnObjectAloneGetsTheDefaults) {
  const Description scene = read(one_object);
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].mesh, "teapot");
  EXPECT_EQ(scene.objects[0].shading, Shading::phong);
  EXPECT_EQ(scene.objects[0].where, "scene.toml:2:8");
  EXPECT_EQ(scene.objects[0].world_from_object, glm::mat4(1));
  EXPECT_TRUE(scene.objects[0].material.model.model);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_FALSE(scene.view.eye);
}

TEST(SceneFile, EverySectionArrives) {
  const Description scene = read(R"(
[picture]
width = 320
height = 200
samples = 16
exposure = -0.5
[camera]
eye = [1, 2.5, 3]
up = [0, 0, 1]
projection = "orthographic"
height = 3
viewer_at_infinity = true
[ambient]
intensity = 0.5
colour = [1, 0.5, 0.25]
[background]
colour = 0.25
)" + one_object);
  EXPECT_EQ(scene.picture.width, 320);
  EXPECT_EQ(scene.picture.height, 200);
  EXPECT_EQ(scene.picture.settings.samples, 16);
  EXPECT_EQ(scene.picture.image.exposure_ev, -0.5);
  EXPECT_EQ(scene.view.eye, glm::dvec3(1, 2.5, 3));
  EXPECT_EQ(scene.view.up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(scene.view.projection, Projection::orthographic);
  EXPECT_EQ(scene.view.height, 3.0);
  EXPECT_TRUE(scene.view.viewer_at_infinity);
  EXPECT_EQ(scene.ambient_intensity, 0.5);
  EXPECT_EQ(scene.ambient_colour, Rgb(1.0, 0.5, 0.25));
  EXPECT_EQ(scene.background, Rgb(0.25));
}

TEST(SceneFile, Lights) {
  const Description scene = read(R"(
[[light]]
direction = [0, 2, 0]
intensity = 0.75
[[light]]
kind = "point"
position = [1, 2, 3]
falloff = "inverse-square"
[[light]]
kind = "spot"
position = [0, 4, 0]
falloff = [1, 0.5, 0.25]
inner = 5
outer = 10
)" + one_object);
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
  EXPECT_EQ(scene.lights[0].direction, glm::dvec3(0, 2, 0));
  EXPECT_EQ(scene.lights[0].intensity, 0.75);
  EXPECT_EQ(scene.lights[1].kind, LightKind::point);
  EXPECT_EQ(scene.lights[1].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.lights[1].constant, 0);
  EXPECT_EQ(scene.lights[1].quadratic, 1);
  EXPECT_EQ(scene.lights[2].kind, LightKind::spot);
  EXPECT_EQ(scene.lights[2].linear, 0.5);
  EXPECT_EQ(scene.lights[2].outer_deg, 10);
}

TEST(SceneFile, AModelAsTextAndAsTableIsTheSame) {
  const Description scene = read(R"(
[material.text]
model = "blinn-phong:kd=.6/.3/.2,n=80"
[material.table]
model = { name = "blinn-phong", kd = [0.6, 0.3, 0.2], n = 80 }
ka = 0.5
[[object]]
mesh = "teapot"
material = "text"
[[object]]
mesh = "teapot"
material = "table"
)");
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.objects[0].material.model.values, scene.objects[1].material.model.values);
  EXPECT_FALSE(scene.objects[0].material.ka);
  EXPECT_EQ(scene.objects[1].material.ka, Rgb(0.5));
}

TEST(SceneFile, AnObjectColourMeansTheSecondForm) {
  const Description scene =
      read("[material.m]\nobject_colour = [1, 0, 0]\n" + one_object + "material = 'm'\n");
  EXPECT_EQ(scene.objects[0].material.form, ColourForm::plastic);
  EXPECT_EQ(scene.objects[0].material.object_colour, Rgb(1.0, 0.0, 0.0));
}

TEST(SceneFile, TangentsAsTextAndAsTable) {
  const auto tangents = [](const std::string& text) {
    return read("[material.m]\ntangents = " + text + "\n[[object]]\nmesh = 'x'\nmaterial = 'm'\n")
        .objects[0]
        .material.tangents.value();
  };
  EXPECT_FALSE(read(one_object).objects[0].material.tangents) << "left to the model";
  EXPECT_EQ(tangents("'along z'").field, TangentField::along);
  expect_near(tangents("'along z'").axis, {0, 0, 1});
  expect_near(tangents("'around x'").axis, {1, 0, 0});
  EXPECT_EQ(tangents("'texcoord'").field, TangentField::texcoord);
  const Tangents lathe = tangents("{ field = 'around', axis = [1, 2, 0], centre = [0, 0, 3] }");
  EXPECT_EQ(lathe.field, TangentField::around);
  expect_near(lathe.axis, {1, 2, 0});
  expect_near(lathe.centre, {0, 0, 3});
}

TEST(SceneFile, TransformsScaleThenRotateThenTranslate) {
  expect_near(placed("translate = [1, 2, 3]", {1, 0, 0}), {2, 2, 3});
  expect_near(placed("scale = 2", {1, 2, 3}), {2, 4, 6});
  expect_near(placed("scale = [1, 2, -1]", {1, 2, 3}), {1, 4, -3});
  expect_near(placed("rotate = { axis = [0, 0, 2], angle = 90 }", {1, 0, 0}), {0, 1, 0});
  expect_near(placed("rotate = [90, 0, 90]", {0, 1, 0}), {0, 0, 1});  // about x first
  expect_near(placed("rotate = [0, 0, 90]\nscale = [2, 1, 1]\ntranslate = [0, 0, 1]", {1, 0, 0}),
              {0, 2, 1});
}

TEST(SceneFile, AMatrixIsReadRowByRow) {
  expect_near(placed("matrix = [[0,-1,0,5], [1,0,0,6], [0,0,1,7], [0,0,0,1]]", {1, 0, 0}),
              {5, 7, 7});
}

struct Mistake {
  const char* scene;
  const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.message; }

class SceneMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SceneMistake, IsNamedWithItsPlace) {
  try {
    read(GetParam().scene);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, std::string(GetParam().message).size()),
              GetParam().message)
        << "all of it: " << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    , SceneMistake,
    testing::Values(
        Mistake{"", "scene.toml:1:1: no [[object]]"}, Mistake{"[camera\n", "scene.toml:1:8: "},
        Mistake{"[camera]\nfov = 1\nfov = 2\n", "scene.toml:3:"},
        Mistake{"[camera]\n  elevatoin = 3\n",
                "scene.toml:2:3: unknown key 'elevatoin' in [camera]; did you mean 'elevation'?"},
        Mistake{"[camrea]\n[[object]]\nmesh = 'teapot'\n",
                "scene.toml:1:2: unknown key 'camrea' in the scene; did you mean 'camera'?"},
        Mistake{"camera = 3", "scene.toml:1:10: camera must be a table"},
        Mistake{"object = 3", "scene.toml:1:10: object is a list: write [[object]]"},
        Mistake{"object = [3]", "scene.toml:1:11: object is a list of tables: [[object]]"},
        Mistake{"[camera]\nfov = 'wide'\n", "scene.toml:2:7: fov must be a number"},
        Mistake{"[camera]\nfov = 200\n", "scene.toml:2:7: fov: 200 is out of range"},
        Mistake{"[camera]\nfov = nan\n", "scene.toml:2:7: fov: nan is not a finite number"},
        Mistake{"[camera]\neye = [0, inf, 0]\n", "scene.toml:2:11: eye: inf is not a finite"},
        Mistake{"[camera]\neye = [0, 0]\n", "scene.toml:2:7: eye: a list of 3 numbers"},
        Mistake{"[camera]\neye = [0, 0, 1]\nazimuth = 3\n", "scene.toml:3:11: eye already says"},
        Mistake{"[camera]\nprojection = 'orthografic'\n",
                "scene.toml:2:14: unknown projection 'orthografic'; did you mean 'orthographic'?"},
        Mistake{"[picture]\nwidth = 0\n", "scene.toml:2:9: width: 0 is out of range"},
        Mistake{"[picture]\nwidth = 999999\n", "scene.toml:2:9: width: 999999 is out"},
        Mistake{"[picture]\nwidth = 1.5\n", "scene.toml:2:9: width must be a whole number"},
        Mistake{"[picture]\nsamples = 5\n", "scene.toml:2:11: 5 samples a pixel"},
        Mistake{"[[light]]\nposition = [0, 0, 0]\n", "scene.toml:2:1: unknown key 'position'"},
        Mistake{"[[light]]\nintensity = -1\n", "scene.toml:2:13: intensity: -1 is out of range"},
        Mistake{"[[light]]\ndirection = [0, 0, 0]\n", "scene.toml:2:13: direction is the zero"},
        Mistake{"[[light]]\nkind = 'point'\nfalloff = [0, 0, 0]\n", "scene.toml:3:11: falloff is"},
        Mistake{"[[light]]\nkind = 'spot'\ninner = 40\n", "scene.toml:3:9: inner is 40 and outer"},
        Mistake{"[[light]]\nkind = 'point'\n", "scene.toml:1:1: a point light or spot has a pos"},
        Mistake{"[[light]]\nkind = 'spot'\n", "scene.toml:1:1: a point light or spot has a pos"},
        Mistake{"[material.m]\n  model = 'blin-phong'\n",
                "scene.toml:2:11: unknown model 'blin-phong'; did you mean 'blinn-phong'?"},
        Mistake{"[material.m]\nmodel = { name = 'blinn-phong', n = 'x' }\n",
                "scene.toml:2:37: model 'blinn-phong': 'n' wants a number"},
        Mistake{"[material.m]\nmodel = { name = 'blinn-phong', kz = 1 }\n", "scene.toml:2:38: "},
        Mistake{"[material.m]\nmodel = { kd = 1 }\n", "scene.toml:2:9: a model has a name"},
        Mistake{"[material.m]\nka = 1.5\n", "scene.toml:2:6: ka: 1.5 is out of range"},
        Mistake{"[material.m]\nform = 3\n", "scene.toml:2:8: form: 3 is out of range"},
        Mistake{"[material.m]\nform = 1\nobject_colour = 1\n", "scene.toml:3:17: only form 2"},
        Mistake{"[material.m]\ntangents = 'around w'\n",
                "scene.toml:2:12: unknown tangents 'around w'; did you mean 'around x'?"},
        Mistake{"[material.m]\ntangents = 'brushed'\n",
                "scene.toml:2:12: unknown tangents 'brushed'; there are: around x, around y, "
                "around z, along x, along y, along z, texcoord"},
        Mistake{"[material.m]\nmodel = 5\n", "scene.toml:2:9: model must be text in quotes"},
        Mistake{"[material.m]\ntangents = 3\n", "scene.toml:2:12: tangents must be"},
        Mistake{"[material.m]\ntangents = { axis = [0, 1, 0] }\n",
                "scene.toml:2:12: tangents have a field: around, along or texcoord"},
        Mistake{"[material.m]\ntangents = { field = 'along', axis = [0, 0, 0] }\n",
                "scene.toml:2:38: axis is the zero vector"},
        Mistake{"[material.m]\ntangents = { field = 'along', centre = [0, 0, 0] }\n",
                "scene.toml:2:40: only around has a centre"},
        Mistake{"[material.m]\ntangents = { field = 'texcoord', axis = [0, 1, 0] }\n",
                "scene.toml:2:41: texcoord has no axis"},
        Mistake{"[material.m]\ntangents = { field = 'around', axes = [0, 1, 0] }\n",
                "scene.toml:2:32: unknown key 'axes'"},
        Mistake{"[[object]]\nname = 'x'\n", "scene.toml:1:1: an object has a mesh"},
        Mistake{"[[object]]\nmesh = 'x'\nmaterial = 'gold'\n",
                "scene.toml:3:12: unknown material 'gold'; the scene has no [material.gold]"},
        Mistake{"[material.gold]\n[[object]]\nmesh = 'x'\nmaterial = 'glod'\n",
                "scene.toml:4:12: unknown material 'glod'; did you mean 'gold'?"},
        Mistake{"[[object]]\nmesh = 'x'\nscale = 0\n", "scene.toml:3:9: scale is 0"},
        Mistake{"[[object]]\nmesh = 'x'\nrotate = { angle = 3, axis = [0, 0, 0] }\n",
                "scene.toml:3:30: axis is the zero vector"},
        Mistake{"[[object]]\nmesh = 'x'\nmatrix = [[1, 0, 0, 0]]\n",
                "scene.toml:3:10: matrix must be a list of 4 rows"},
        Mistake{"[[object]]\nmesh = 'x'\nmatrix = [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]\n",
                "scene.toml:3:10: the last row"},
        Mistake{"[[object]]\nmesh = 'x'\nscale = 2\nmatrix = "
                "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]\n",
                "scene.toml:3:9: matrix already places the object"}));

}  // namespace
}  // namespace scanlit::studio
