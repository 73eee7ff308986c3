// scanlit watch: what it tells of scan conversion is what the engine did.
#include <gtest/gtest.h>

#include <map>

#include "lessons/studio/watch/example.h"
#include "lessons/studio/watch/moments.h"
#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

using studio::EdgeCentre;
using studio::ScannedRow;
using studio::ScannedTriangle;
using studio::ScanStory;
using Pixel = std::pair<int, int>;

ScanStory example_story(const Rect& part = {0, 0, 32, 18}) {
  const studio::WatchExample example = studio::watch_example();
  return studio::watch_scan_conversion(example.scene, example.camera, {}, 32, 18, part);
}

TEST(Watch, ItsWinnersAreThePicturesTriangles) {
  const studio::WatchExample example = studio::watch_example();
  Framebuffer picture(32, 18, {.ids = true});
  render(example.scene, example.camera, {}, picture);
  for (const Rect& part : {Rect{0, 0, 32, 18}, Rect{7, 3, 20, 15}}) {
    std::map<Pixel, std::uint32_t> winner;
    int lost = 0;
    const ScanStory story = example_story(part);
    for (const ScannedTriangle& triangle : story.triangles)
      for (const ScannedRow& row : triangle.rows)
        for (int x = row.x_begin; x < row.x_end; ++x)
          if (row.nearer[std::size_t(x - row.x_begin)])
            winner[{x, row.y}] = triangle.triangle;
          else
            ++lost;
    EXPECT_GT(lost, 0) << "the third triangle passes through the others";
    for (int y = part.y_begin; y < part.y_end; ++y)
      for (int x = part.x_begin; x < part.x_end; ++x) {
        const auto found = winner.find({x, y});
        EXPECT_EQ(found == winner.end() ? no_id : found->second,
                  picture.triangle_id[std::size_t(32 * y + x)])
            << "pixel " << x << "," << y;
      }
  }
}

TEST(Watch, ACentreOnTheSharedEdgeCountsForOneTriangle) {
  std::map<Pixel, int> on_edge, counted;
  const ScanStory story = example_story();
  for (std::size_t k = 0; k < 2; ++k)
    for (const ScannedRow& row : story.triangles[k].rows)
      for (const EdgeCentre& centre : row.edge) {
        ++on_edge[{centre.x, row.y}];
        counted[{centre.x, row.y}] += centre.counts;
      }
  for (int i = 1; i < 12; ++i) {  // between the shared edge's ends
    EXPECT_EQ((on_edge[{4 + i, 2 + i}]), 2) << i;
    EXPECT_EQ((counted[{4 + i, 2 + i}]), 1) << i;
  }
  EXPECT_EQ((counted[{10, 2}]), 1) << "a horizontal top edge";
}

TEST(Watch, ShowsEveryRowWhereThatDoesNotTakeTooLong) {
  ScanStory story;
  story.triangles.resize(54);
  for (ScannedTriangle& triangle : story.triangles) triangle.rows.resize(10);
  // Of each triangle its edges and 10 rows; then what is visible, twice, and the shaded picture.
  EXPECT_EQ(moments_of(story, 1).size(), 54u * 11 + 2 + 3);
  story.triangles.resize(55);
  story.triangles.back().rows.resize(10);
  EXPECT_EQ(moments_of(story, 1).size(), 55u + 2 + 3) << "else every triangle when it is done";
  EXPECT_EQ(moments_of(story, 1)[0].row, 9);
}

TEST(Watch, WritesAnAnimation) {
  const Folder folder;
  for (const char* scene : {"", "cube --size 12x9 --region 2,1,8,6"}) {
    const Outcome outcome =
        folder.run(std::string("watch -o a.gif --cell 8 --fps 1 ") + scene, "SCANLIT_FONT=/none");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("a.gif: ")) << outcome.out;
    EXPECT_EQ(folder.read("a.gif").substr(0, 6), "GIF89a");
  }
}

TEST(Watch, RefusesWhatCannotBeWatched) {
  const Folder folder;
  struct Bad {
    const char *arguments, *message;
  };
  for (const auto& [arguments, message] :
       {Bad{"-o a.png", "a.png: an animation is a .gif file"}, Bad{"cube", "--output"},
        Bad{"-o a.gif --region 0,0,4,4", "INPUT: is missing"},
        Bad{"-o a.gif --shading flat", "INPUT: is missing"},
        Bad{"cube -o a.gif --region 0,0,4", "--region: '0,0,4' is not X,Y,W,H"},
        Bad{"cube -o a.gif --region 0,0,0,4", "--region: 1 to 96 columns"},
        Bad{"cube -o a.gif --region 950,0,32,18", "--region: '950,0,32,18' reaches beyond"},
        Bad{"cube -o a.gif --region 0,0,4,4", "--region: no triangle covers a pixel there"},
        Bad{"teapot:64 --size 60x40 --region 10,5,40,30 -o a.gif", "too many to watch"},
        Bad{"cube -o no/a.gif", "no/a.gif"}, Bad{"cube -o a.gif --cell 7", "--cell: 7"},
        Bad{"cube -o a.gif --fps 0", "--fps: 0"}}) {
    expect_refusal(folder.run(std::string("watch ") + arguments), message);
    EXPECT_EQ(folder.files(), std::vector<std::string>{}) << arguments;
  }
}

}  // namespace
}  // namespace scanlit::test
