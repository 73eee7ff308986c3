// Pictures appear whole or not at all, and only where they were asked for.
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>

#include "tests/unit/image_files.h"

namespace scanlit {
namespace {

using namespace test;

class OutputFileTest : public ImageTest {};

TEST_F(OutputFileTest, ReplacesAFileAndLeavesNothingElse) {
  const fs::path file = in_folder("a.png");
  std::ofstream(file) << "old";
  write_image(file, gradient(5, 5));
  EXPECT_EQ(read_image(file).width, 5);
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFileTest, ALinkStaysALinkToWhatIsReplaced) {
  fs::create_directory(in_folder("elsewhere"));
  std::ofstream(in_folder("elsewhere/a.png")) << "old";
  fs::create_symlink("elsewhere/a.png", in_folder("link.png"));
  write_image(in_folder("link.png"), gradient(5, 5));
  EXPECT_TRUE(fs::is_symlink(in_folder("link.png")));
  EXPECT_EQ(read_image(in_folder("elsewhere/a.png")).width, 5);
}

TEST_F(OutputFileTest, WritesIntoTheWorkingFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(in_folder(""));
  write_image("a.png", gradient(5, 5));
  fs::current_path(before);
  EXPECT_TRUE(fs::exists(in_folder("a.png")));
}

TEST_F(OutputFileTest, RefusesNamesItCannotUse) {
  const Framebuffer framebuffer = gradient(4, 4);
  const auto refusal = [&](const fs::path& file) {
    const std::string error = error_of([&] { write_image(file, framebuffer); });
    EXPECT_EQ(error, error_of([&] { check_image_target(file, 4, 4); }));
    EXPECT_EQ(error.find(file.string() + ": "), 0u) << error;
    return error.substr(std::min(error.size(), file.string().size() + 2));
  };
  EXPECT_EQ(refusal("a.gif"),
            "unknown image format '.gif'; there are: .png, .jpg, .jpeg, .bmp, .tga, .tif, .tiff, "
            ".ppm, .hdr, .exr");
  EXPECT_EQ(refusal("picture").find("the name has no suffix"), 0u);
  EXPECT_EQ(refusal(in_folder("none/a.png")),
            "there is no folder '" + in_folder("none").string() + "'");
  std::ofstream(in_folder("file")) << "x";
  EXPECT_EQ(refusal(in_folder("file/a.png")), "cannot create a file there: Not a directory");
  EXPECT_EQ(refusal("/proc/a.png"), "cannot create a file there: No such file or directory");
  EXPECT_EQ(refusal(in_folder(std::string(300, 'a') + ".png")),
            "cannot create a file there: File name too long");
  fs::create_directory(in_folder("folder.png"));
  EXPECT_EQ(refusal(in_folder("folder.png")), "is a folder; the name of a file is needed");
  EXPECT_EQ(files(), 2u);
}

TEST_F(OutputFileTest, RefusesWhatItCannotWrite) {
  EXPECT_EQ(error_of([&] { write_aovs("a.png", gradient(4, 4)); }),
            "a.png: only an .exr file holds named channels");
  EXPECT_THROW(write_image(in_folder("a.png"), Framebuffer()), Error);
  EXPECT_THROW(check_image_target(in_folder("a.png"), 16385, 4), Error);
  Framebuffer torn = gradient(4, 4);
  torn.colour.pop_back();
  EXPECT_THROW(write_image(in_folder("a.png"), torn), Error);
  for (const double ev : {33.0, std::nan(""), -std::numeric_limits<double>::infinity()}) {
    ImageOptions options;
    options.exposure_ev = ev;
    EXPECT_THROW(write_image(in_folder("a.png"), gradient(4, 4), options), Error);
  }
  EXPECT_EQ(files(), 0u);
}

// No file may grow beyond so many bytes while this lives: to a program that ignores the signal, a
// write beyond it fails as one on a full disk does.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    previous_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, previous_handler_);
  }

 private:
  rlimit previous_{};
  void (*previous_handler_)(int) = nullptr;
};

TEST_F(OutputFileTest, AFullDiskIsAnErrorInEveryFormatAndLeavesTheOldFile) {
  Framebuffer noise(300, 300);
  std::uint32_t state = 1;
  for (float& value : noise.colour)
    value = float((state = state * 1664525u + 1013904223u) >> 8) / float(1 << 24);
  for (const char* suffix : {".png", ".jpg", ".bmp", ".tga", ".tif", ".ppm", ".hdr", ".exr"}) {
    const fs::path file = in_folder(std::string("a") + suffix);
    write_image(file, noise);
    const auto size = fs::file_size(file);
    // The first byte, the middle, and what is written last: an index, or a buffer's rest.
    for (const auto limit : {std::uintmax_t(0), size / 2, size - 1}) {
      std::ofstream(file) << "old";
      std::string error;
      {
        const FileSizeLimit disk(limit);
        error = error_of([&] { write_image(file, noise); });
      }
      EXPECT_EQ(error, file.string() + ": cannot write: File too large") << limit;
      EXPECT_EQ(fs::file_size(file), 3u);
      EXPECT_EQ(files(), 1u);
    }
    fs::remove(file);
  }
}

TEST_F(OutputFileTest, ReadingSaysWhatIsWrong) {
  const auto refusal = [&](const fs::path& file) { return error_of([&] { read_image(file); }); };
  const auto none = in_folder("none.png"), text = in_folder("text.png");
  EXPECT_EQ(refusal(none).find(none.string() + ": cannot read the image: "), 0u);
  std::ofstream(text) << "not a picture";
  EXPECT_EQ(refusal(text).find(text.string() + ": cannot read the image: "), 0u);
  write_image(in_folder("cut.png"), gradient(64, 64));
  fs::resize_file(in_folder("cut.png"), fs::file_size(in_folder("cut.png")) / 2);
  EXPECT_NE(refusal(in_folder("cut.png")), "no error");
  std::ofstream(in_folder("huge.ppm")) << "P6 2000000000 2000000000 255\n";
  EXPECT_NE(refusal(in_folder("huge.ppm")), "no error");
}

}  // namespace
}  // namespace scanlit
