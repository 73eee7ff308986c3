// What tests/ratchet/run counts the instructions of: small frames, each drawn twice, so that the
// second finds memory and clusters as most frames do. One thread. The scenes are small ones of
// tests/bench/bench_scenes.h.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <numbers>

#include "models/blinn_phong.h"
#include "models/cook_torrance.h"
#include "rasterizer/render.h"
#include "tests/bench/bench_shapes.h"

namespace scanlit::ratchet {

struct Drawing {
  Scene scene;
  Camera camera{.eye = {0, 0, 4.15}, .target = {0, 0, 0}, .fov_deg = 45, .near = 1, .far = 100};
  RenderSettings settings{.threads = 1, .clamp_vertex_colours = true};
  Framebuffer framebuffer{256, 144, {.format = ColourFormat::linear_8bit}};
  Renderer renderer;

  FrameStats draw() { return renderer.render(scene, camera, settings, framebuffer); }
};

namespace {

const char* const blinn_phong = "blinn-phong:kd=.7/.3/.2,ks=.3,n=32";

/// A sphere in the middle, under one far light.
Drawing sphere(Shading shading, const char* model, int stacks = 26, int slices = 40) {
  Drawing drawing;
  Object& object = drawing.scene.objects.emplace_back();
  object.mesh = std::make_shared<Mesh>(bench::sphere(stacks, slices));
  object.material = {.model = models::make(model).model, .ka = {0.035, 0.015, 0.01}};
  object.shading = shading;
  object.sides = Sides::front;
  drawing.scene.lights = {{.direction = {1, 1, 1}}};
  return drawing;
}

/// 64 spheres behind one another, the first the farthest.
Drawing layers() {
  Drawing drawing = sphere(Shading::phong, blinn_phong);
  drawing.camera.eye = {0, 0, 0};
  drawing.camera.target = {0, 0, -1};
  drawing.scene.objects.resize(64, drawing.scene.objects[0]);
  for (int i = 0; i < 64; ++i) {
    const float s = 1 + 0.05f * float(63 - i);
    drawing.scene.objects[std::size_t(i)].world_from_object = {
        {s, 0, 0, 0}, {0, s, 0, 0}, {0, 0, s, 0}, {0, 0, -2.73f * s, 1}};
  }
  return drawing;
}

/// Under 16 point lights on a circle before it.
Drawing point_lights() {
  Drawing drawing = sphere(Shading::phong, blinn_phong);
  drawing.scene.lights.clear();
  for (int i = 0; i < 16; ++i) {
    const double t = std::numbers::pi * i / 8;
    drawing.scene.lights.push_back({.kind = LightKind::point,
                                    .position = {3 * std::cos(t), 3 * std::sin(t), 2},
                                    .constant = 0,
                                    .quadratic = 1});
  }
  return drawing;
}

struct Case {
  const char* name;
  Drawing (*make)();
};
const Case cases[] = {
    {"gouraud", [] { return sphere(Shading::gouraud, blinn_phong); }},
    {"phong", [] { return sphere(Shading::phong, blinn_phong); }},
    {"cook-torrance",
     [] {
       return sphere(Shading::phong,
                     "cook-torrance:D=beckmann,m=.3,G=vcavity,F=conductor,"
                     "eta=.143/.375/1.442,k=3.983/2.386/1.603,kd=.3/.2/.05,ks=1");
     }},
    // 60,000 triangles, smaller than pixels.
    {"fine-mesh", [] { return sphere(Shading::phong, blinn_phong, 151, 200); }},
    {"64-layers", layers},
    {"16-lights", point_lights},
};

}  // namespace
}  // namespace scanlit::ratchet

/// Named and left alone, so that Callgrind can be told to count in it and nowhere else.
extern "C" [[gnu::noipa]] void counted_frame(scanlit::ratchet::Drawing& drawing) { drawing.draw(); }

/// Prints the compiler's version, or each scene's name and the pixels it covers.
int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--compiler") == 0) {
    std::puts("gcc-" __VERSION__);
    return 0;
  }
  for (const auto& [name, make] : scanlit::ratchet::cases) {
    scanlit::ratchet::Drawing drawing = make();
    std::printf("%s %ld\n", name, long(drawing.draw().covered_pixels));
    counted_frame(drawing);
  }
}
