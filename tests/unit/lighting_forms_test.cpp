// Colour forms, ambient light and viewers, against the lecture's equations in double.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "rasterizer/framebuffer.h"
#include "rasterizer/lighting.h"
#include "tests/unit/lighting_studio.h"

namespace scanlit {
namespace {

using namespace test;

// ---------------------------------------------------------------------------------- colour forms

TEST(Lighting, TheTwoColourForms) {
  const glm::dvec3 light_colour(1, 0.5, 0.75), object_colour(0.25, 0.8, 0.5);
  Studio studio;
  studio.scene.lights = {{.intensity = 1.5, .colour = {1, 0.5, 0.75}, .direction = {1, 1, 2}}};
  studio.material().object_colour = {0.25, 0.8, 0.5};
  const glm::dvec3 l = glm::normalize(glm::dvec3(1, 1, 2));
  for (const ColourForm form : {ColourForm::tinted, ColourForm::plastic}) {
    studio.material().form = form;
    const auto lit = studio.light(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 v = glm::normalize(studio.camera.eye - points[i].position);
      const Braces part = braces(points[i].normal, l, v);
      const bool plastic = form == ColourForm::plastic;
      expect_near(lit[i].diffuse, 1.5 * part.diffuse * (plastic ? object_colour : light_colour),
                  1e-5);
      expect_near(lit[i].glossy, 1.5 * part.glossy * light_colour, 1e-5);
    }
  }
}

TEST(Lighting, AmbientInBothForms) {
  Studio studio;
  studio.scene.ambient = {0.9, 0.6, 0.3};
  studio.material().ka = {0.1, 0.2, 0.4};
  studio.material().object_colour = {0.5, 0.25, 1};
  const auto ambient = [&] { return ambient_radiance(studio.scene, studio.material()); };
  EXPECT_FLOAT_EQ(ambient().r, 0.09f);
  EXPECT_FLOAT_EQ(ambient().g, 0.12f);
  EXPECT_FLOAT_EQ(ambient().b, 0.12f);
  studio.material().form = ColourForm::plastic;  // Ia is the mean, 0.6
  EXPECT_FLOAT_EQ(ambient().r, 0.03f);
  EXPECT_FLOAT_EQ(ambient().g, 0.03f);
  EXPECT_FLOAT_EQ(ambient().b, 0.24f);
}

TEST(Lighting, AmbientFollowsADiffusePartThatVaries) {
  Studio studio;
  studio.scene.ambient = {0.9, 0.6, 0.3};
  studio.material().ka = Rgb<double>(0.01);
  for (const auto& point : studio.light(points))
    expect_near(point.ambient, {0.009, 0.006, 0.003}, 1e-7);

  studio.material().ambient_share = 0.25;
  studio.material().model = models::make("phong:kd=noise(a=.1/.2/.3,b=.9/.1/.5)").model;
  const auto expect = [&](const glm::dvec3& light) {
    const auto lit = studio.light(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3& at = points[i].position;
      const Rgb<double> kd_here =
          studio.material()
              .model
              ->evaluate({0, 0, 1}, Vec3<double>{0, 0, 1}, {.object_position = {at.x, at.y, at.z}})
              .diffuse;
      const glm::dvec3 ka = 0.01 + 0.25 * glm::dvec3(kd_here.r, kd_here.g, kd_here.b);
      expect_near(lit[i].ambient, ka * light, 1e-6);
    }
  };
  expect({0.9, 0.6, 0.3});
  studio.material().form = ColourForm::plastic;
  studio.material().object_colour = {0.5, 0.25, 1};
  expect(0.6 * glm::dvec3(0.5, 0.25, 1));
}

TEST(Lighting, TheFormsAgreeToTheBitWhereTheyMeanTheSame) {
  // Ka_rgb = Ka object_colour, Kd_rgb = Kd object_colour, Ks_rgb = Ks light_colour, in powers of
  // two, so that no product rounds.
  Studio tinted, plastic;
  tinted.scene.ambient = plastic.scene.ambient = Rgb<double>(0.75);
  tinted.scene.lights = {{.intensity = 2, .direction = {1, 1, 2}}};
  plastic.scene.lights = {{.intensity = 2, .colour = {1, 0.25, 0.125}, .direction = {1, 1, 2}}};
  tinted.material().ka = {0.125, 0.25, 0.0625};
  tinted.material().model =
      models::make("blinn-phong:kd=.25/.5/.125,ks=.25/.0625/.03125,n=20").model;
  plastic.material().ka = Rgb<double>(0.25);
  plastic.material().form = ColourForm::plastic;
  plastic.material().object_colour = {0.5, 1, 0.25};
  const auto one = tinted.light(points), other = plastic.light(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(one[i].diffuse, other[i].diffuse);
    EXPECT_EQ(one[i].glossy, other[i].glossy);
  }
  EXPECT_EQ(ambient_radiance(tinted.scene, tinted.material()),
            ambient_radiance(plastic.scene, plastic.material()));
}

// --------------------------------------------------------------------------------------- viewers

TEST(Lighting, AViewerAtInfinityAndAnOrthographicOneSeeAlongOneDirection) {
  const glm::dvec3 l = glm::normalize(glm::dvec3(-1, 0, 1));
  for (const bool orthographic : {false, true}) {
    Studio studio;
    studio.scene.lights = {{.direction = {-1, 0, 1}}};
    studio.camera = {.eye = {2, 0, 2}, .target = {0, 0, 0}};
    if (orthographic)
      studio.camera.projection = Projection::orthographic;
    else
      studio.camera.viewer_at_infinity = true;
    const glm::dvec3 v = glm::normalize(glm::dvec3(1, 0, 1));
    const auto lit = studio.light(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(lit[i].glossy.r, braces(points[i].normal, l, v).glossy, 1e-5);
    EXPECT_NEAR(lit[0].glossy.r, ks, 1e-5) << "mirror direction";
  }
}

// ---------------------------------------------------------------------------------- in a picture

TEST(Lighting, ThePictureHasTheRadianceOfTheEquation) {
  // A square facing an orthographic viewer, lit and seen at known angles.
  const auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh->normals.assign(4, {0, 0, 1});
  mesh->indices = {0, 1, 2, 0, 2, 3};
  const double slope = std::sqrt(0.75);
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    Studio studio;
    Object& square = studio.scene.objects[0];
    square.mesh = mesh;
    square.shading = shading;
    square.material.ka = Rgb<double>(0.1);
    studio.scene.ambient = Rgb<double>(0.5);
    studio.scene.lights = {{.intensity = 0.5, .colour = {1, 0.5, 0}, .direction = {slope, 0, 0.5}}};
    const Camera camera{.eye = {0, 0, 4}, .projection = Projection::orthographic, .far = 10};
    Framebuffer picture(8, 8);
    render(studio.scene, camera, studio.settings, picture);
    const Braces part = braces({0, 0, 1}, {slope, 0, 0.5}, {0, 0, 1});
    const float* pixel = &picture.colour[4 * (3 * 8 + 3)];
    EXPECT_NEAR(pixel[0], 0.05 + 0.5 * (part.diffuse + part.glossy), 1e-5);
    EXPECT_NEAR(pixel[1], 0.05 + 0.25 * (part.diffuse + part.glossy), 1e-5);
    EXPECT_NEAR(pixel[2], 0.05, 1e-5);
  }
}

}  // namespace
}  // namespace scanlit
