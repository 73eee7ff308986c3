// (11) Image, of several frames: an animated GIF, for which OpenImageIO chooses 255 colours a frame
// and dithers.
#pragma once

#include <filesystem>
#include <functional>

#include "rasterizer/image.h"

namespace scanlit {

/// What an animation may be: GIF counts time in hundredths of a second, and viewers slow down what
/// is faster than 50 frames a second. Beyond the first count of pixels the plug-in's choice of
/// colours overflows an int; the second makes a file of about a gigabyte.
constexpr double min_frames_per_second = 1, max_frames_per_second = 50;
constexpr std::int64_t max_animation_frame = 1 << 23, max_animation_pixels = 1'000'000'000;

/// Throws the Error that write_animation would throw for this suffix, size and count of frames.
void check_animation(const std::filesystem::path& file, int width, int height, int frames);

/// Asks for one frame after another, all of one size, encodes each, and writes a GIF that repeats
/// for ever; whole or not at all. The time a frame stands is the nearest hundredth of a second.
/// Throws Error naming the file as write_image does, and where the frames differ in size.
void write_animation(const std::filesystem::path& file, int frames,
                     const std::function<Framebuffer(int)>& frame, double frames_per_second,
                     Encoding encoding = Encoding::srgb);

}  // namespace scanlit
