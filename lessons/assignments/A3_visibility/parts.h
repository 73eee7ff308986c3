// A3's parts.
#pragma once

#include "lessons/assignments/A3_visibility/questions.h"
#include "lessons/assignments/A3_visibility/reference.h"
#include "lessons/assignments/judge/assignment.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::assignments::visibility {

using namespace a3;

// parts_of_depth.cpp
Finding test_depth_of(Examination& e);  // A3.1
Finding test_depth_at(Examination& e);  // A3.2
Finding test_stored(Examination& e);    // A3.3
Finding test_replaces(Examination& e);  // A3.4
Finding test_draw(Examination& e);      // A3.5

// parts_of_a_picture.cpp
Finding test_picture(Examination& e);  // A3.6
Framebuffer right_picture(const DepthVariant& variant);
Framebuffer starter_picture();  // each triangle over the one before

}  // namespace scanlit::assignments::visibility
