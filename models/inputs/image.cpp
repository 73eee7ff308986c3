#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/texture.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>

#include "models/inputs/image_library.h"
#include "rasterizer/error.h"
#include "rasterizer/image/image_encoding.h"

namespace scanlit::models {

namespace {

constexpr int largest_side = 16384;

/// An image file's pixels, in its own number format; three channels.
struct Pixels {
  OIIO::ImageBuf buffer;
  int channel[3];
  bool integer;

  /// A row as linear light, or as it is.
  void read_row(int y, bool decode, float* rgb) const {
    const OIIO::ImageSpec& spec = buffer.spec();
    const OIIO::ROI row(spec.x, spec.x + spec.width, spec.y + y, spec.y + y + 1, spec.z, spec.z + 1,
                        0, spec.nchannels);
    std::vector<float> all(std::size_t(spec.width) * std::size_t(spec.nchannels));
    buffer.get_pixels(row, OIIO::TypeDesc::FLOAT, all.data());
    for (int x = 0; x < spec.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const float value = all[std::size_t(x * spec.nchannels + channel[c])];
        rgb[3 * x + c] = decode ? float(linear_from_srgb(value)) : value;
      }
  }
};

void refuse_what_is_no_number(const std::string& name, const Pixels& pixels) {
  const OIIO::ImageSpec& spec = pixels.buffer.spec();
  std::vector<float> row(3 * std::size_t(spec.width));
  for (int y = 0; y < spec.height; ++y) {
    pixels.read_row(y, false, row.data());
    const auto bad =
        std::find_if_not(row.begin(), row.end(), [](float x) { return std::isfinite(x); });
    if (bad != row.end())
      throw Error(name, "pixel (" + std::to_string((bad - row.begin()) / 3) + ", " +
                            std::to_string(y) + ") is not a finite number");
  }
}

/// libpng writes what is wrong to standard error too, before OpenImageIO reports it.
class QuietStandardError {
 public:
  QuietStandardError() : before_(dup(STDERR_FILENO)) {
    const int nowhere = open("/dev/null", O_WRONLY);
    if (before_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~QuietStandardError() {
    if (before_ < 0) return;
    dup2(before_, STDERR_FILENO);
    close(before_);
  }
  QuietStandardError(const QuietStandardError&) = delete;
  QuietStandardError& operator=(const QuietStandardError&) = delete;

 private:
  int before_;
};

/// A pipe would be waited for, and a device has no end.
void refuse_what_is_no_file(const std::string& name) {
  std::error_code ignored;  // what cannot be opened is refused when it is
  const auto status = std::filesystem::status(name, ignored);
  if (std::filesystem::is_directory(status)) throw Error(name, "is a folder, not an image");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw Error(name, "is not a regular file");
}

std::shared_ptr<const Pixels> read_pixels(const std::string& name) {
  refuse_what_is_no_file(name);
  const QuietStandardError quiet;
  const auto fail = [&](std::string reason) {
    const std::string known = "Invalid image file \"" + name + "\": ";
    if (reason.starts_with(known)) reason.erase(0, known.size());
    throw Error(name, "cannot read the image: " + reason.substr(0, reason.find('\n')));
  };
  // Else colours would come multiplied by alpha.
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  auto pixels = std::make_shared<Pixels>();
  OIIO::ImageBuf& buffer = pixels->buffer;
  buffer.reset(name, 0, 0, nullptr, &config);
  if (!buffer.init_spec(name, 0, 0)) fail(buffer.geterror());
  const OIIO::ImageSpec& spec = buffer.spec();
  if (std::max(spec.width, spec.height) > largest_side || spec.depth > 1)
    fail("it has " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
         " pixels; a side may have " + std::to_string(largest_side));
  if (!buffer.read(0, 0, true, OIIO::TypeUnknown)) fail(buffer.geterror());

  const char* names[3] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    const int named = spec.channelindex(names[c]);
    pixels->channel[c] = named >= 0 ? named : spec.nchannels >= 3 ? c : 0;
  }
  pixels->integer = !spec.format.is_floating_point();
  if (!pixels->integer) refuse_what_is_no_number(name, *pixels);
  return pixels;
}

/// What the texture system reads in place of files, by made-up names.
struct Source {
  std::shared_ptr<const Pixels> pixels;
  bool decode;
};
std::mutex sources_mutex;
std::map<std::string, Source>& sources() {
  static std::map<std::string, Source> all;
  return all;
}

/// The texture system filters what it reads: it must be given linear light, which no 8-bit file
/// holds, and given it from memory, so that files cannot change or vanish during a rendering.
class SourceReader final : public OIIO::ImageInput {
 public:
  static OIIO::ImageInput* create() { return new SourceReader; }

  const char* format_name() const override { return "scanlit"; }

  bool open(const std::string& name, OIIO::ImageSpec& spec) override {
    const std::lock_guard lock(sources_mutex);
    source_ = sources().at(name);
    const OIIO::ImageSpec& from = source_.pixels->buffer.spec();
    m_spec = OIIO::ImageSpec(from.width, from.height, 3, OIIO::TypeDesc::FLOAT);
    spec = m_spec;
    return true;
  }

  bool read_native_scanline(int, int, int y, int, void* data) override {
    source_.pixels->read_row(y, source_.decode, static_cast<float*>(data));
    return true;
  }

  bool close() override {
    source_ = {};
    return true;
  }

 private:
  Source source_{};
};

OIIO::TextureSystem& texture_system() {
  static OIIO::TextureSystem& system = []() -> OIIO::TextureSystem& {
    auto* created = OIIO::TextureSystem::create(true);
    created->attribute("autotile", 64);
    created->attribute("automip", 1);  // makes the smaller levels, which our sources lack
    return *created;
  }();
  return system;
}

/// One source in the texture system, as long as somebody has it.
class Texture {
 public:
  Texture(std::shared_ptr<const Pixels> pixels, bool decode) {
    static std::atomic<int> count{0};
    name_ = "scanlit-image-" + std::to_string(++count);
    {
      const std::lock_guard lock(sources_mutex);
      sources()[name_] = {std::move(pixels), decode};
    }
    OIIO::ImageCache::create(true)->add_file(OIIO::ustring(name_), &SourceReader::create);
    handle_ = texture_system().get_texture_handle(OIIO::ustring(name_));
  }
  ~Texture() {
    texture_system().invalidate(OIIO::ustring(name_));
    const std::lock_guard lock(sources_mutex);
    sources().erase(name_);
  }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  OIIO::TextureSystem::TextureHandle* handle() const { return handle_; }

 private:
  std::string name_;
  OIIO::TextureSystem::TextureHandle* handle_;
};

class Image final : public Input {
 public:
  Image(std::shared_ptr<const Pixels> pixels, const std::string& space, const std::string& wrap)
      : as_colour_(pixels, pixels->integer && space != "linear"),
        as_number_(pixels, pixels->integer && space == "srgb") {
    options_.swrap = options_.twrap = OIIO::TextureOpt::decode_wrapmode(wrap.c_str());
    // Between pixels, not a smooth curve near them: an image of numbers shows its numbers.
    options_.interpmode = OIIO::TextureOpt::InterpBilinear;
  }

  bool needs_texcoord_derivatives() const override { return true; }

  void evaluate(const PointSpan& points, std::size_t channels, float* const* out) const override {
    OIIO::TextureSystem& system = texture_system();
    auto* thread = system.get_perthread_info();
    auto* handle = (channels == 1 ? as_number_ : as_colour_).handle();
    const bool filtered = points.texcoord_dx[0] != nullptr;
    OIIO::TextureOpt options = options_;  // the system writes into it
    options.mipmode = filtered ? OIIO::TextureOpt::MipModeAniso : OIIO::TextureOpt::MipModeNoMIP;
    const auto grows = [&](const float* const* texcoord, std::size_t i, int c) {
      return filtered ? in_reach(texcoord[c][i]) : 0.0f;
    };
    for (std::size_t i = 0; i < points.size; ++i) {
      float rgb[3] = {};
      // The image's t grows downwards.
      system.texture(handle, thread, options, in_reach(points.texcoord[0][i]),
                     1 - in_reach(points.texcoord[1][i]), grows(points.texcoord_dx, i, 0),
                     -grows(points.texcoord_dx, i, 1), grows(points.texcoord_dy, i, 0),
                     -grows(points.texcoord_dy, i, 1), 3, rgb);
      for (std::size_t c = 0; c < channels; ++c) out[c][i] = rgb[c];
    }
  }

 private:
  /// Farther out, the texture system's whole numbers of pixels overflow. NaN becomes the bound.
  static float in_reach(float texcoord) {
    constexpr float reach = 1e4f;
    return std::min(std::max(-reach, texcoord), reach);
  }

  Texture as_colour_, as_number_;
  OIIO::TextureOpt options_;
};

std::shared_ptr<const Input> make(const std::filesystem::path& file, const std::string& space,
                                  const std::string& wrap) {
  return std::make_shared<Image>(read_pixels(file.string()), space, wrap);
}

}  // namespace
}  // namespace scanlit::models

extern "C" const scanlit::models::ImageInputMaker scanlit_image_input = scanlit::models::make;
