#include "rasterizer/tile_colours.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstring>

#include "rasterizer/strides.h"

namespace scanlit {

namespace {

/// Past the caches: lines that are written whole need not be read first, and nobody reads them
/// soon.
void stream(const std::uint8_t* from, std::size_t size, std::uint8_t* to) {
  constexpr std::size_t line = cache_line;
  const hn::ScalableTag<std::uint8_t> bytes;
  std::uint8_t* const end = to + size;
  const auto to_line = std::size_t(-reinterpret_cast<std::uintptr_t>(to) % line);
  const std::size_t before = std::min(to_line, size);
  std::memcpy(to, from, before);
  for (to += before, from += before; to + line <= end; to += line, from += line)
    for (std::size_t i = 0; i < line; i += hn::MaxLanes(bytes))
      hn::Stream(hn::LoadU(bytes, from + i), bytes, to + i);
  std::memcpy(to, from, std::size_t(end - to));
}

/// Widened, so that a line of 8-bit pixels comes from one place as a whole: parts of it would be
/// written by way of the caches, and everything after them would wait.
Rect in_whole_lines(const Rect& touched, const Rect& tile) {
  constexpr int pixels = int(cache_line) / 4;
  const int begin = touched.x_begin - tile.x_begin, end = touched.x_end - tile.x_begin;
  return {tile.x_begin + begin / pixels * pixels, touched.y_begin,
          std::min(tile.x_begin + (end + pixels - 1) / pixels * pixels, tile.x_end), touched.y_end};
}

}  // namespace

void put_behind(std::span<float> rgba, const Rgb<double>& background) {
  if (background == Rgb<double>(0.0)) return;
  const float channels[3] = {float(background.r), float(background.g), float(background.b)};
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) rgba[i + c] += (1 - rgba[i + 3]) * channels[c];
}

ColourTarget TileColours::begin(const Frame& frame, const Rect& tile, const Rect& touched,
                                Framebuffer& f) {
  frame_ = &frame, f_ = &f, tile_ = tile, touched_ = in_whole_lines(touched, tile);
  floats_ = f.format == ColourFormat::linear_float;
  make_background();
  const auto width = std::size_t(tile.x_end - tile.x_begin);
  const auto size = 4 * width * std::size_t(tile.y_end - tile.y_begin);
  target_ = {.width = width,
             .first_pixel = index_of_pixel(packed_pixel(tile.x_begin, tile.y_begin), width),
             .format = f.format,
             .near = may_be_near(frame)};
  const bool sums = frame.settings.samples > 1;
  if (floats_) {
    target_ = {.linear = f.colour.data(), .width = std::size_t(f.width)};
  } else if (sums) {
    sums_.resize(size), target_.linear = sums_.data();
  } else {
    // The end of a run may be stored as a whole vector (SpanShader::write_runs).
    codes_.resize(size + 4 * max_lanes), target_.codes = codes_.data();
  }
  const auto count = std::size_t(touched_.x_end - touched_.x_begin);
  for (int y = touched_.y_begin; y < touched_.y_end; ++y) {
    if (sums)
      std::fill_n(linear_row(y), 4 * count, 0.0f);
    else
      std::memcpy(floats_ ? static_cast<void*>(linear_row(y)) : code_row(y), background_.data(),
                  pixel_size() * count);
  }
  return target_;
}

void TileColours::make_background() {
  const Rgb<double>& colour = frame_->scene.background;
  const float linear[4] = {float(colour.r), float(colour.g), float(colour.b), 0};
  const std::size_t size = pixel_size() * std::size_t(tile_.x_end - tile_.x_begin);
  background_.resize(size);
  if (floats_)
    std::memcpy(background_.data(), linear, sizeof linear);
  else
    PixelEncoder(f_->format).row(linear, background_.data());
  for (std::size_t done = pixel_size(); done < size; done *= 2)
    std::memcpy(&background_[done], background_.data(), std::min(done, size - done));
}

void TileColours::finish() {
  for (int y = tile_.y_begin; y < tile_.y_end; ++y) {
    const bool touched = y >= touched_.y_begin && y < touched_.y_end;
    write(background_.data(), y, tile_.x_begin, touched ? touched_.x_begin : tile_.x_end);
    if (!touched) continue;
    finish_touched(y);
    write(background_.data(), y, touched_.x_end, tile_.x_end);
  }
  // Before another thread is told that they are there.
  hwy::FlushStream();
}

void TileColours::finish_touched(int y) {
  if (target_.codes) return write(code_row(y), y, touched_.x_begin, touched_.x_end);
  if (frame_->settings.samples == 1) return;
  const std::span row(linear_row(y), 4 * std::size_t(touched_.x_end - touched_.x_begin));
  put_behind(row, frame_->scene.background);
  if (!floats_) PixelEncoder(f_->format).row(row, in_framebuffer(touched_.x_begin, y));
}

void TileColours::write(const std::uint8_t* from, int y, int x_begin, int x_end) {
  stream(from, pixel_size() * std::size_t(x_end - x_begin), in_framebuffer(x_begin, y));
}

std::uint8_t* TileColours::in_framebuffer(int x, int y) const {
  const std::size_t pixel = index_of_pixel(packed_pixel(x, y), std::size_t(f_->width));
  auto* const plane =
      floats_ ? reinterpret_cast<std::uint8_t*>(f_->colour.data()) : f_->rgba8.data();
  return plane + pixel_size() * pixel;
}

}  // namespace scanlit
