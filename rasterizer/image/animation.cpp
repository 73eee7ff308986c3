#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "rasterizer/error.h"
#include "rasterizer/image/checked_stream.h"
#include "rasterizer/image/image_encoding.h"
#include "rasterizer/image/openimageio.h"
#include "rasterizer/image/output_file.h"

namespace scanlit {
namespace {

/// The plug-in cuts 100 / rate off to whole hundredths of a second: half a one more, and rounding
/// takes none away.
float rate_for(double frames_per_second) {
  return float(100 / (std::round(100 / frames_per_second) + 0.5));
}

std::vector<std::uint8_t> encoded(const Framebuffer& frame, const EightBitEncoder& encode) {
  std::vector<std::uint8_t> codes;
  codes.reserve(3 * frame.pixel_count());
  for (std::size_t i = 0; i < frame.colour.size(); ++i)
    if (i % 4 != 3) codes.push_back(encode(frame.colour[i]));  // 3 is alpha
  return codes;
}

}  // namespace

void openimageio::check_animation(const std::filesystem::path& file, int width, int height,
                                  int frames) {
  if (file.extension() != ".gif")
    throw Error(file.string(), "an animation is a .gif file; of no other format");
  const std::string asked = std::to_string(width) + "x" + std::to_string(height) + " pixels";
  const std::int64_t pixels = std::int64_t(width) * height;
  if (pixels > max_animation_frame)
    throw Error(file.string(), asked + " are too many for a frame of a GIF; " +
                                   std::to_string(max_animation_frame) + " are the most");
  if (pixels * frames > max_animation_pixels)
    throw Error(file.string(), std::to_string(frames) + " frames of " + asked +
                                   " would make a file of gigabytes; " +
                                   std::to_string(max_animation_pixels) +
                                   " pixels in all are the most");
}

void openimageio::write_animation(const std::filesystem::path& file, int frames,
                                  const std::function<Framebuffer(int)>& frame,
                                  double frames_per_second, Encoding encoding) {
  const EightBitEncoder encode(encoding);
  OutputFile target(file);  // outlives the stream, which outlives the plug-in
  CheckedStream stream(target.stream());
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("gif", &stream);
  if (!output) throw Error(file.string(), "cannot write gif: " + OIIO::geterror());
  const auto check = [&](bool succeeded) {
    if (succeeded && stream.write_errno() == 0) return;
    const std::string reason =
        stream.write_errno() ? std::strerror(stream.write_errno()) : output->geterror();
    throw Error(file.string(), "cannot write: " + reason.substr(0, reason.find('\n')));
  };
  OIIO::ImageSpec spec;
  for (int i = 0; i < frames; ++i) {
    const Framebuffer picture = frame(i);
    if (i == 0) {
      check_animation(file, picture.width, picture.height, frames);
      spec = OIIO::ImageSpec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
      spec.attribute("FramesPerSecond", rate_for(frames_per_second));
      const std::vector<OIIO::ImageSpec> specs(std::size_t(frames), spec);
      check(output->open(file.string(), frames, specs.data()));
    } else {
      if (picture.width != spec.width || picture.height != spec.height)
        throw Error(file.string(), "frame " + std::to_string(i) + " has another size than frame 0");
      check(output->open(file.string(), spec, OIIO::ImageOutput::AppendSubimage));
    }
    check(output->write_image(OIIO::TypeDesc::UINT8, encoded(picture, encode).data()));
  }
  check(output->close());
  target.commit(stream.write_errno());
}

}  // namespace scanlit
