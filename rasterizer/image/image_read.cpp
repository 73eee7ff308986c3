#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>

#include "rasterizer/error.h"
#include "rasterizer/image/image_encoding.h"
#include "rasterizer/image/image_planes.h"
#include "rasterizer/image/openimageio.h"

namespace scanlit {
namespace {

// A file read channel by channel, by name: the order of channels in a file is the format's choice.
class ChannelReader {
 public:
  explicit ChannelReader(const std::filesystem::path& file)
      : name_(file.string()), input_(OIIO::ImageInput::open(name_)) {
    if (!input_) fail(OIIO::geterror());
    const int width = input_->spec().width, height = input_->spec().height;
    if (std::max(width, height) > max_framebuffer_size)
      fail("it has " + std::to_string(width) + "x" + std::to_string(height) +
           " pixels; a side may have " + std::to_string(max_framebuffer_size));
  }

  const OIIO::ImageSpec& spec() const { return input_->spec(); }

  bool has(const char* channel) const { return spec().channelindex(channel) >= 0; }

  /// Every `stride`-th element of `values`, from its `first` on.
  template <class T>
  void read(const char* channel, OIIO::TypeDesc type, std::vector<T>& values, int first,
            int stride) {
    const int index = spec().channelindex(channel);
    if (index < 0) fail("it has no channel " + std::string(channel));
    if (!input_->read_image(0, 0, index, index + 1, type, values.data() + first,
                            std::ptrdiff_t(stride * sizeof(T))))
      fail(input_->geterror());
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(name_, "cannot read the image: " + reason.substr(0, reason.find('\n')));
  }

 private:
  std::string name_;
  std::unique_ptr<OIIO::ImageInput> input_;
};

}  // namespace

Framebuffer openimageio::read_image(const std::filesystem::path& file, Encoding encoding) {
  ChannelReader reader(file);
  Planes planes;
  planes.depth = reader.has("depth.Z");
  planes.normal = reader.has("normal.X");
  planes.ids = reader.has("id.object");
  planes.parts = reader.has("ambient.R");
  planes.cost = reader.has("cost.tests");
  Framebuffer framebuffer(reader.spec().width, reader.spec().height, planes);

  for (const FloatPlane& plane : float_planes) {
    auto& values = framebuffer.*plane.values;
    for (int c = 0; c < plane.channels && !values.empty(); ++c) {
      if (plane.names[c] == std::string_view("A") && !reader.has("A"))
        for (std::size_t i = c; i < values.size(); i += 4) values[i] = 1;
      else
        reader.read(plane.names[c], OIIO::TypeDesc::FLOAT, values, c, plane.channels);
    }
  }
  for (const IdPlane& plane : id_planes)
    if (auto& ids = framebuffer.*plane.values; !ids.empty())
      reader.read(plane.name, OIIO::TypeDesc::UINT32, ids, 0, 1);

  if (!reader.spec().format.is_floating_point() && encoding == Encoding::srgb)
    for (std::size_t i = 0; i < framebuffer.colour.size(); ++i)
      if (i % 4 != 3) framebuffer.colour[i] = float(linear_from_srgb(framebuffer.colour[i]));
  return framebuffer;
}

}  // namespace scanlit
