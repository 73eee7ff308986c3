#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "rasterizer/image/image_planes.h"
#include "tests/golden/golden.h"

namespace scanlit::golden {
namespace {

constexpr double max_differing_share = 0.001;

std::string place(const Framebuffer& framebuffer, std::size_t pixel) {
  return "(" + std::to_string(pixel % framebuffer.width) + ", " +
         std::to_string(pixel / framebuffer.width) + ")";
}

// "normal" of "normal.X"; the colour's channels have no such prefix.
std::string plane_name(const char* channel) {
  const std::string name = channel;
  return name.find('.') == std::string::npos ? "colour" : name.substr(0, name.find('.'));
}

bool same_shape(const Framebuffer& actual, const Framebuffer& expected,
                std::vector<std::string>& problems) {
  const auto size = [](const Framebuffer& f) {
    return std::to_string(f.width) + "x" + std::to_string(f.height);
  };
  if (size(actual) != size(expected)) {
    problems.push_back("the picture is " + size(actual) + ", its reference " + size(expected));
    return false;
  }
  const auto match = [&](const std::string& plane, bool in_actual, bool in_expected) {
    if (in_actual != in_expected)
      problems.push_back((in_actual ? "the reference" : "the picture") + std::string(" has no ") +
                         plane);
  };
  for (const FloatPlane& plane : float_planes)
    match(plane_name(plane.names[0]), !(actual.*plane.values).empty(),
          !(expected.*plane.values).empty());
  for (const IdPlane& plane : id_planes)
    match(plane.name, !(actual.*plane.values).empty(), !(expected.*plane.values).empty());
  return problems.empty();
}

// OpenImageIO takes a NaN for equal to a NaN, and counts none as a difference.
void require_finite(const Framebuffer& picture, std::vector<std::string>& problems) {
  for (const FloatPlane& plane : float_planes) {
    const auto& values = picture.*plane.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isfinite(values[i])) continue;
      problems.push_back(plane_name(plane.names[0]) + " is " + std::to_string(values[i]) + " at " +
                         place(picture, i / plane.channels));
      break;
    }
  }
}

// To the bit, not through OpenImageIO, which compares floats: ids above 2^24 would blur.
template <class T>
void require_equal(const std::string& name, const Framebuffer& shape, const std::vector<T>& actual,
                   const std::vector<T>& expected, int first, int stride,
                   std::vector<std::string>& problems) {
  std::size_t differing = 0, at = 0;
  for (std::size_t i = first; i < actual.size(); i += stride)
    if (std::memcmp(&actual[i], &expected[i], sizeof(T)) != 0 && differing++ == 0) at = i;
  if (differing == 0) return;
  std::ostringstream text;
  text.precision(9);
  text << name << " differs in " << differing << " pixels; the first is "
       << place(shape, at / stride) << ": " << actual[at] << " instead of " << expected[at];
  problems.push_back(text.str());
}

OIIO::ImageBuf wrap(const Framebuffer& shape, int channels, const std::vector<float>& values) {
  // ImageBuf has no constructor for constant pixels; nothing here writes to it.
  return {OIIO::ImageSpec(shape.width, shape.height, channels, OIIO::TypeDesc::FLOAT),
          const_cast<float*>(values.data())};
}

Difference require_close(const FloatPlane& plane, const Framebuffer& actual,
                         const Framebuffer& expected, const Tolerance& tolerance,
                         std::vector<std::string>& problems) {
  const auto a = wrap(actual, plane.channels, actual.*plane.values);
  const auto b = wrap(expected, plane.channels, expected.*plane.values);
  OIIO::ROI first_three = a.roi();  // alpha is compared to the bit
  first_three.chend = std::min(first_three.chend, 3);
  const auto found =
      OIIO::ImageBufAlgo::compare(a, b, tolerance.absolute, tolerance.absolute, tolerance.relative,
                                  tolerance.relative, first_three);
  const Difference difference{found.maxerror, found.meanerror, found.rms_error,
                              std::int64_t(found.nfail)};
  if (difference.pixels > tolerance.pixels) {
    std::ostringstream text;
    text << plane_name(plane.names[0]) << " differs in " << difference.pixels
         << " pixels by more than " << tolerance.absolute << " and " << 100 * tolerance.relative
         << " %, where " << tolerance.pixels << " may; most by " << difference.max << " in "
         << plane.names[found.maxc] << " at (" << found.maxx << ", " << found.maxy << ")";
    problems.push_back(text.str());
  }
  return difference;
}

}  // namespace

Comparison compare(const Framebuffer& actual, const Framebuffer& expected,
                   const Tolerance& tolerance) {
  Comparison result;
  if (!same_shape(actual, expected, result.problems)) return result;
  if (tolerance.pixels > max_differing_share * double(actual.pixel_count()))
    result.problems.push_back("the case lets " + std::to_string(tolerance.pixels) +
                              " pixels differ, which is more than .1 % of them");
  require_finite(actual, result.problems);
  require_equal("coverage", actual, actual.colour, expected.colour, 3, 4, result.problems);
  require_equal("depth", actual, actual.depth, expected.depth, 0, 1, result.problems);
  for (const IdPlane& plane : id_planes)
    require_equal(plane.name, actual, actual.*plane.values, expected.*plane.values, 0, 1,
                  result.problems);
  for (const FloatPlane& plane : float_planes) {
    if (plane.values == &Framebuffer::depth || (actual.*plane.values).empty()) continue;
    const auto difference = require_close(plane, actual, expected, tolerance, result.problems);
    if (plane.values == &Framebuffer::colour) result.colour = difference;
  }
  return result;
}

}  // namespace scanlit::golden
