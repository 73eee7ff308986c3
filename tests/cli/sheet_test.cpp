// scanlit sheet: materials side by side.
#include <gtest/gtest.h>

#include "rasterizer/image.h"
#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

TEST(Sheet, ShowsEveryMaterialThereIs) {
  const Folder folder;
  const Outcome outcome = folder.run("sheet --size 40x30 --shape teapot:2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with("sheet.png: ")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, " materials\n")) << outcome.out;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"sheet.png"});
}

TEST(Sheet, HasAsManyColumnsAsItIsTold) {
  const Folder folder;
  const std::string command = "sheet lambert phong blinn-phong --shape cube --size 60x40 -o s.exr";
  for (const auto& [columns, across, down] : {std::tuple{"1", 1, 3}, {"2", 2, 2}, {"9", 3, 1}}) {
    EXPECT_EQ(folder.run(command + " --columns " + columns).exit_code, 0);
    const Framebuffer sheet = read_image(folder.path() / "s.exr");
    EXPECT_EQ(sheet.width / 60, across);
    EXPECT_GE(sheet.height, 40 * down);
    EXPECT_LT(sheet.height, 100 * down);
  }
}

TEST(Sheet, EachCellHasItsOwnMaterialAndShading) {
  const Folder folder;
  const auto draw = [&](const std::string& arguments) {
    const Outcome outcome =
        folder.run("sheet --size 60x40 --shape sphere:8 -o s.png " + arguments, "SCANLIT_FONT=/no");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return folder.read("s.png");
  };
  const std::string phong = draw("lambert:kd=1/0/0 phong");
  EXPECT_NE(phong, draw("phong lambert:kd=1/0/0"));
  EXPECT_NE(phong, draw("lambert:kd=1/0/0 phong --shading flat"));
  EXPECT_NE(phong, draw("lambert:kd=1/0/0 phong --shading gouraud"));
}

TEST(Sheet, WithoutAFontThereAreNoLabelsAndAWarning) {
  const Folder folder;
  const std::string command = "sheet lambert --shape sphere:8 --size 90x60 -o ";
  const Outcome without = folder.run(command + "without.png", "SCANLIT_FONT=/nowhere.ttf");
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_TRUE(without.err.starts_with("warning: no font was found")) << without.err;
  EXPECT_EQ(folder.run(command + "with.png").err, "");
  EXPECT_NE(folder.read("with.png"), folder.read("without.png")) << "labels are drawn";
}

TEST(Sheet, RefusesWhatItCannotDo) {
  const Folder folder;
  struct Bad {
    const char *arguments, *message;
  };
  for (const auto& [arguments, message] :
       {Bad{"lambrt", "did you mean 'lambert'?"}, Bad{"lambert --shape teepot", "'teepot'"},
        Bad{"lambert --shading x", "--shading"}, Bad{"lambert --size 10", "--size: '10'"},
        Bad{"lambert --columns 0", "--columns: 0 is out of range"},
        Bad{"lambert -o x.docx", "unknown image format"},
        Bad{"lambert lambert --columns 2 --size 9000x10", "16384"},
        Bad{"lambert -o no/x.png", "no/x.png: there is no folder"}}) {
    expect_refusal(folder.run(std::string("sheet ") + arguments), message);
    EXPECT_EQ(folder.files(), std::vector<std::string>{}) << arguments;
  }
}

}  // namespace
}  // namespace scanlit::test
