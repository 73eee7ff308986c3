#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <span>

#include "rasterizer/error.h"
#include "rasterizer/image/checked_stream.h"
#include "rasterizer/image/image_encoding.h"
#include "rasterizer/image/image_planes.h"
#include "rasterizer/image/openimageio.h"
#include "rasterizer/image/output_file.h"

namespace scanlit {
namespace {

struct Format {
  const char* suffix;
  const char* writer;  // OpenImageIO's name; its guess would be made from a temporary file's name
  bool floating;       // 32-bit linear light, else 8-bit codes
  int channels;
};
constexpr Format formats[] = {
    {".png", "png", false, 3},    {".jpg", "jpeg", false, 3},  {".jpeg", "jpeg", false, 3},
    {".bmp", "bmp", false, 3},    {".tga", "targa", false, 3}, {".tif", "tiff", false, 3},
    {".tiff", "tiff", false, 3},  {".ppm", "pnm", false, 3},   {".hdr", "hdr", true, 3},
    {".exr", "openexr", true, 4},
};

const Format& format_of(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  std::string known;
  for (const Format& format : formats) {
    if (suffix == format.suffix) return format;
    known += (known.empty() ? "" : ", ") + std::string(format.suffix);
  }
  throw Error(file.string(), (suffix.empty() ? "the name has no suffix to tell the image format"
                                             : "unknown image format '" + suffix + "'") +
                                 "; there are: " + known);
}

// Rows from top to bottom into a file that appears when all of them are there.
class ScanlineWriter {
 public:
  ScanlineWriter(const std::filesystem::path& file, const Format& format,
                 const OIIO::ImageSpec& spec)
      : name_(file.string()), file_(file), stream_(file_.stream()) {
    output_ = OIIO::ImageOutput::create(format.writer, &stream_);
    if (!output_)
      throw Error(name_, "cannot write " + std::string(format.writer) + ": " + OIIO::geterror());
    check(output_->open(name_, spec));
  }

  /// One row after another: OIIO::TypeUnknown says that pixels have the file's own layout.
  void write(int y_begin, int y_end, OIIO::TypeDesc type, const void* pixels) {
    check(output_->write_scanlines(y_begin, y_end, 0, type, pixels));
  }

  void finish() {
    check(output_->close());
    file_.commit(stream_.write_errno());
  }

 private:
  void check(bool succeeded) {
    if (succeeded && stream_.write_errno() == 0) return;
    const std::string reason =
        stream_.write_errno() ? std::strerror(stream_.write_errno()) : output_->geterror();
    throw Error(name_, "cannot write: " + reason.substr(0, reason.find('\n')));
  }

  std::string name_;
  OutputFile file_;  // outlives the stream, which outlives the plug-in
  CheckedStream stream_;
  std::unique_ptr<OIIO::ImageOutput> output_;
};

// The same picture is to make the same file, byte for byte: unless told, OpenImageIO adds the time.
OIIO::ImageSpec make_spec(const Framebuffer& framebuffer, int channels, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(framebuffer.width, framebuffer.height, channels, type);
  spec.attribute("DateTime", "");
  return spec;
}

// So many rows are converted at a time: a whole converted copy of the largest picture would take
// gigabytes. A multiple of every block height of EXR.
constexpr int rows_at_a_time = 64;

template <class WriteRows>
void for_each_block_of_rows(const Framebuffer& framebuffer, const WriteRows& write_rows) {
  for (int y = 0; y < framebuffer.height; y += rows_at_a_time)
    write_rows(y, std::min(y + rows_at_a_time, framebuffer.height));
}

std::span<const float> pixels_of_rows(const Framebuffer& framebuffer, int y_begin, int y_end) {
  const std::size_t row = 4 * std::size_t(framebuffer.width);
  return std::span(framebuffer.colour).subspan(y_begin * row, (y_end - y_begin) * row);
}

void write_floating(ScanlineWriter& writer, const Framebuffer& framebuffer, int channels,
                    float exposure) {
  std::vector<float> converted;
  for_each_block_of_rows(framebuffer, [&](int y_begin, int y_end) {
    const auto pixels = pixels_of_rows(framebuffer, y_begin, y_end);
    converted.clear();
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
      for (int c = 0; c < 3; ++c) converted.push_back(exposure * pixels[i + c]);
      if (channels == 4) converted.push_back(pixels[i + 3]);
    }
    writer.write(y_begin, y_end, OIIO::TypeDesc::FLOAT, converted.data());
  });
}

// Returns the count of clipped pixels.
std::int64_t write_eight_bit(ScanlineWriter& writer, const Framebuffer& framebuffer,
                             Encoding encoding, float exposure) {
  const EightBitEncoder encode(encoding);
  std::int64_t clipped = 0;
  std::vector<std::uint8_t> codes;
  for_each_block_of_rows(framebuffer, [&](int y_begin, int y_end) {
    const auto pixels = pixels_of_rows(framebuffer, y_begin, y_end);
    codes.clear();
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
      bool clips = false;
      for (int c = 0; c < 3; ++c) {
        const float value = exposure * pixels[i + c];
        clips |= encode.clips(value);
        codes.push_back(encode(value));
      }
      clipped += clips && pixels[i + 3] > 0;
    }
    writer.write(y_begin, y_end, OIIO::TypeDesc::UINT8, codes.data());
  });
  return clipped;
}

void validate_planes(const std::filesystem::path& file, const Framebuffer& framebuffer) {
  validate_size(framebuffer.width, framebuffer.height);
  const auto holds = [&](std::size_t size, int channels) {
    return size == 0 || size == channels * framebuffer.pixel_count();
  };
  bool whole = !framebuffer.colour.empty();
  for (const FloatPlane& plane : float_planes)
    whole &= holds((framebuffer.*plane.values).size(), plane.channels);
  for (const IdPlane& plane : id_planes) whole &= holds((framebuffer.*plane.values).size(), 1);
  if (!whole) throw Error(file.string(), "the framebuffer's planes do not have its size");
}

}  // namespace

void openimageio::check_image_target(const std::filesystem::path& file, int width, int height) {
  format_of(file);
  validate_size(width, height);  // every format above holds max_framebuffer_size
  OutputFile{file};              // made and removed: the one test that says what the system allows
}

ImageReport openimageio::write_image(const std::filesystem::path& file,
                                     const Framebuffer& framebuffer, const ImageOptions& options) {
  const Format& format = format_of(file);
  validate_planes(file, framebuffer);
  if (!(std::abs(options.exposure_ev) <= max_exposure_ev))
    throw Error(file.string(), "exposure " + std::to_string(options.exposure_ev) +
                                   " EV is out of range; it must be within -" +
                                   std::to_string(max_exposure_ev) + ".." +
                                   std::to_string(max_exposure_ev));
  const auto exposure = float(std::exp2(options.exposure_ev));
  auto spec = make_spec(framebuffer, format.channels,
                        format.floating ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  const std::string_view writer_name = format.writer;
  // Only PNG can say it: TIFF would get an Exif folder that makes the file unreadable.
  if (writer_name == "png")
    spec.attribute("oiio:ColorSpace", options.encoding == Encoding::srgb ? "sRGB" : "Linear");
  if (writer_name == "jpeg") {
    // Defaults of JPEG smear highlights: colours at half resolution.
    spec.attribute("compression", "jpeg:95");
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  ScanlineWriter writer(file, format, spec);
  ImageReport report;
  if (format.floating)
    write_floating(writer, framebuffer, format.channels, exposure);
  else
    report.clipped_pixels = write_eight_bit(writer, framebuffer, options.encoding, exposure);
  writer.finish();
  return report;
}

void openimageio::write_aovs(const std::filesystem::path& file, const Framebuffer& framebuffer) {
  const Format& format = format_of(file);
  if (std::string_view(format.writer) != "openexr")
    throw Error(file.string(), "only an .exr file holds named channels");
  validate_planes(file, framebuffer);

  struct Channel {
    const void* values;  // of pixel 0; float and id are 4 bytes each
    std::size_t stride;  // in values
  };
  std::vector<Channel> channels;
  auto spec = make_spec(framebuffer, 0, OIIO::TypeDesc::FLOAT);
  const auto add = [&](const char* name, OIIO::TypeDesc type, const void* values, int stride) {
    channels.push_back({values, std::size_t(stride)});
    spec.channelnames.emplace_back(name);
    spec.channelformats.push_back(type);
  };
  for (const FloatPlane& plane : float_planes) {
    const auto& values = framebuffer.*plane.values;
    for (int c = 0; c < plane.channels && !values.empty(); ++c)
      add(plane.names[c], OIIO::TypeDesc::FLOAT, values.data() + c, plane.channels);
  }
  for (const IdPlane& plane : id_planes)
    if (const auto& ids = framebuffer.*plane.values; !ids.empty())
      add(plane.name, OIIO::TypeDesc::UINT32, ids.data(), 1);
  spec.nchannels = int(channels.size());
  spec.alpha_channel = 3;

  ScanlineWriter writer(file, format, spec);
  std::vector<std::uint32_t> interleaved;
  for_each_block_of_rows(framebuffer, [&](int y_begin, int y_end) {
    const std::size_t first = std::size_t(y_begin) * framebuffer.width;
    const std::size_t last = std::size_t(y_end) * framebuffer.width;
    interleaved.resize((last - first) * channels.size());
    auto* next = interleaved.data();
    for (std::size_t pixel = first; pixel < last; ++pixel)
      for (const Channel& channel : channels)
        std::memcpy(next++, static_cast<const char*>(channel.values) + 4 * pixel * channel.stride,
                    4);
    writer.write(y_begin, y_end, OIIO::TypeDesc::UNKNOWN, interleaved.data());
  });
  writer.finish();
}

}  // namespace scanlit
