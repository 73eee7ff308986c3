// scanlit reflect --plot sphere, slice: pictures in image files.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "rasterizer/image.h"
#include "tests/cli/run_program.h"

namespace scanlit::test {
namespace {

TEST(ReflectPicture, SpheresAndSlicesHoldTheModelsValues) {
  const Folder folder;
  const std::string tail = " --cell 100 -o picture.exr";
  EXPECT_EQ(folder.run("reflect lambert:kd=.8/.5/.2 --plot sphere --angles 0,60" + tail).err, "");
  const Framebuffer spheres = read_image(folder.path() / "picture.exr");
  const auto red = [](const Framebuffer& f, int x, int y) {
    return f.colour[4 * (std::size_t(y) * std::size_t(f.width) + std::size_t(x))];
  };
  float brightest[2] = {};
  for (int y = 30; y < spheres.height - 40; ++y)
    for (int x = 0; x < spheres.width; ++x)
      brightest[x > spheres.width / 2] =
          std::max(brightest[x > spheres.width / 2], red(spheres, x, y));
  EXPECT_NEAR(brightest[0], 0.8, 1e-3);
  EXPECT_NEAR(brightest[1], 0.8, 1e-3);

  EXPECT_EQ(folder.run("reflect lambert:kd=.8/.5/.2 --plot slice" + tail).err, "");
  const Framebuffer slice = read_image(folder.path() / "picture.exr");
  EXPECT_NEAR(red(slice, slice.width / 2, slice.height / 2), 0.8, 1e-3);
}

TEST(ReflectPicture, WithoutAFontThereAreNoLabelsAndAWarning) {
  const Folder folder;
  const Outcome outcome = folder.run("reflect lambert --plot slice --cell 60 -o picture.png",
                                     "SCANLIT_FONT=/nowhere.ttf");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.err.starts_with("warning: no font was found")) << outcome.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"picture.png"});
}

}  // namespace
}  // namespace scanlit::test
