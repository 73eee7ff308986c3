#include "rasterizer/image/openimageio.h"

extern "C" const scanlit::openimageio::Functions scanlit_images{
    .write_image = scanlit::openimageio::write_image,
    .check_image_target = scanlit::openimageio::check_image_target,
    .write_aovs = scanlit::openimageio::write_aovs,
    .read_image = scanlit::openimageio::read_image,
    .check_animation = scanlit::openimageio::check_animation,
    .write_animation = scanlit::openimageio::write_animation,
    .text_width = scanlit::openimageio::text_width,
    .draw_text = scanlit::openimageio::draw_text,
};
