// scanlit explain: one pixel's derivation, and that it is the picture's.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "rasterizer/image.h"
#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

using Json = nlohmann::json;

Json explained(const Folder& folder, const std::string& arguments) {
  const Outcome outcome = folder.run("explain " + arguments + " --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return Json::parse(outcome.out);
}

TEST(Explain, GivesTheFloatsThatRenderDraws) {
  const Folder folder;
  folder.write("lights.toml",
               "[picture]\nwidth = 90\nheight = 70\n"
               "[[light]]\nkind = 'point'\nposition = [1, 2, 2]\nfalloff = [1, 0, 0.2]\n"
               "[[light]]\nkind = 'spot'\nposition = [-1, 2, 2]\ndirection = [1, -2, -2]\n"
               "[[light]]\ndirection = [0, 0.4, 1]\ncolour = [1, 0.5, 0.2]\n"
               "[[object]]\nmesh = 'teapot:4'\n");
  for (const char* options :
       {"--shading flat --samples 1", "--shading gouraud --samples 4 --model material:copper",
        "--shading phong --samples 16 --model finished-wood:kd=wood-colour",
        "--shading phong --samples 8 --model phong --object-colour .8,.2,.1"}) {
    const auto drawn = folder.run(std::string("render lights.toml -o picture.exr ") + options);
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    const Framebuffer picture = read_image(folder.path() / "picture.exr");
    for (const auto& [x, y] : {std::pair{45, 40}, {30, 36}, {61, 26}, {46, 22}}) {
      const Json json = explained(folder, std::string("lights.toml ") + options + " --pixel " +
                                              std::to_string(x) + "," + std::to_string(y));
      for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(json["linear"][c].get<float>(),
                  picture.colour[4 * (std::size_t(y) * 90 + std::size_t(x)) + c])
            << options << ", pixel " << x << "," << y;
    }
  }
}

TEST(Explain, TheTermsMultiplyToTheBraces) {
  const Folder folder;
  const std::string pixel = "sphere:20 --size 90x70 --pixel 45,30 --model ";
  for (const char* model : {"cook-torrance:D=ggx,a=.4,F=gold", "torrance-sparrow",
                            "material:copper", "cook-torrance:a=noise(a=.2,b=.6),D=ggx,ks=.7"}) {
    const Json json = explained(folder, pixel + "'" + model + "'");
    const Json light = json["fragments"][0]["points"][0]["lights"][0];
    const double ks = contains(model, "ks") ? 0.7 : 1;
    const double expected = ks * std::numbers::pi / 4 * light["D"].get<double>() *
                            light["G"].get<double>() * light["F"][1].get<double>() /
                            light["N.V"].get<double>();
    EXPECT_NEAR(light["braces"]["glossy"][1].get<double>(), expected, 1e-4 * expected) << model;
    EXPECT_GT(expected, 0) << model;
  }
}

TEST(Explain, FitsOnAProjectorsScreenInTheLecturesNames) {
  const Folder folder;
  for (const char* shading : {"flat", "gouraud", "phong"}) {
    const Outcome outcome = folder.run(
        "explain teapot:6 --size 300x200 --light 1,1,1 --samples 1 --pixel 150,100 "
        "--model cook-torrance:kd=.2 --shading " +
        std::string(shading));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto lines = lines_of(outcome.out);
    EXPECT_LE(lines.size(), shading[0] == 'g' ? 62u : 45u) << outcome.out;
    for (const std::string& line : lines) EXPECT_LE(line.size(), 100u) << line;
    for (const char* word : {"span", "barycentric", "N.L", "V.H", "D, G", "F(V.H)", "Kd (N.L)",
                             "Ks pi/4 D G F / (N.V)", "ambient", "linear", "sRGB"})
      EXPECT_TRUE(contains(outcome.out, word)) << word << "\n" << outcome.out;
  }
}

TEST(Explain, SaysWhatEverySampleSees) {
  const Folder folder;
  const std::string edge = "sphere:8 --size 60x60 --samples 4 --pixel ";
  // Along a row from outside inwards there is a pixel whose samples do not all see the sphere.
  bool mixed = false;
  for (int x = 0; x < 30 && !mixed; ++x) {
    const Json json = explained(folder, edge + std::to_string(x) + ",30");
    int seeing = 0;
    for (const Json& sample : json["samples"]) seeing += !sample["layers"].empty();
    double weight = 0;
    for (const Json& fragment : json["fragments"]) weight += fragment["weight"].get<double>();
    EXPECT_EQ(weight, seeing / 4.0);
    mixed = seeing > 0 && seeing < 4;
    if (mixed) {
      const std::string text = folder.run("explain " + edge + std::to_string(x) + ",30").out;
      EXPECT_TRUE(contains(text, "sample 3")) << text;
      EXPECT_TRUE(contains(text, "the background")) << text;
    }
  }
  EXPECT_TRUE(mixed);
}

TEST(Explain, SaysOneLineOfTheBackground) {
  const Outcome outcome = Folder().run("explain sphere --size 60x40 --pixel 0,0 --background 1");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(lines_of(outcome.out).size(), 1u);
  EXPECT_TRUE(contains(outcome.out, "shows the background: 255 255 255")) << outcome.out;
}

TEST(Explain, RefusesPixelsThatAreNotThere) {
  const Folder folder;
  struct Bad {
    const char *arguments, *message;
  };
  for (const auto& [arguments, message] :
       {Bad{"sphere --size 60x40 --pixel 60,0", "--pixel: 60 is out of range; allowed is 0 to 59"},
        Bad{"sphere --size 60x40 --pixel 0,-1", "--pixel: -1 is out of range"},
        Bad{"sphere --pixel 5", "--pixel: '5' is not X,Y"},
        Bad{"sphere --pixel 5,x", "--pixel: 'x'"}, Bad{"sphere", "--pixel"},
        Bad{"no.obj --pixel 1,1", "no.obj"},
        Bad{"sphere --size 60x40 --pixel 0,0 --fragment 0", "--fragment: the pixel has none"},
        Bad{"sphere --size 60x40 --pixel 30,20 --fragment 9", "--fragment: 9 is out of range"}})
    expect_refusal(folder.run(std::string("explain ") + arguments), message);
}

}  // namespace
}  // namespace scanlit::test
