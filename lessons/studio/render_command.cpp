// scanlit render
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <set>
#include <sstream>

#include "lessons/studio/commands.h"
#include "lessons/studio/cost_picture.h"
#include "lessons/studio/program.h"
#include "lessons/studio/progress_bar.h"
#include "lessons/studio/render_options.h"
#include "lessons/studio/stats_report.h"
#include "lessons/studio/table.h"
#include "lessons/studio/text.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

/// One file can have many names.
std::filesystem::path full_path(const std::filesystem::path& name) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(name));
}

void check_target(const std::filesystem::path& target, const RenderOptions& options,
                  const Picture& picture) {
  check_image_target(target, picture.width, picture.height);
  if (full_path(target) == full_path(options.input))  // by a link, for its suffix is another
    throw Error(target.string(), "is the input's own file");
}

void check_targets(const RenderOptions& options, const Picture& picture) {
  check_target(options.output_file(), options, picture);
  for (const std::filesystem::path& aov : options.aov_files()) {
    if (aov.extension() != ".exr")
      throw Error("--aov", "'" + aov.string() +
                               "' is not an .exr file, which alone holds channels, nor the word " +
                               RenderOptions::aov_cost);
    if (full_path(aov) == full_path(options.output_file()))
      throw Error("--aov", "'" + aov.string() + "' is the picture's own file");
    check_target(aov, options, picture);
  }
  if (!options.wants_cost_picture()) return;
  check_cost_picture(picture.width, picture.height);
  check_target(cost_file(options.output_file()), options, picture);
}

/// Each mesh's warnings once, however many objects share it.
void print_warnings(const Scene& scene) {
  std::set<const Mesh*> seen;
  for (const Object& object : scene.objects)
    if (seen.insert(object.mesh.get()).second)
      for (const std::string& warning : object.mesh->warnings)
        warn(object.mesh->name + ": " + warning);
}

void print_missing_texcoords(const Scene& scene) {
  std::set<const Mesh*> seen;
  for (const Object& object : scene.objects)
    if (object.material.tangents.field == TangentField::texcoord && object.mesh->tangents.empty() &&
        seen.insert(object.mesh.get()).second)
      warn(object.mesh->name +
           ": has no texture coordinates for tangents to follow; they go around y");
}

/// The highest exposure, in tenths, at which the brightest channel is not clipped.
double fitting_exposure(const Framebuffer& framebuffer) {
  float brightest = 0;
  for (std::size_t i = 0; i < framebuffer.colour.size(); ++i)
    if (i % 4 != 3) brightest = std::max(brightest, framebuffer.colour[i]);  // 3 is alpha
  return std::floor(-10 * std::log2(double(brightest))) / 10 + 0.0;          // + 0.0: not "-0"
}

void report_picture(const RenderOptions& options, const Picture& picture, const FrameStats& stats,
                    const ImageReport& image, const Framebuffer& framebuffer) {
  if (stats.covered_pixels == 0) warn("nothing of the scene is in view");
  if (image.clipped_pixels > 0)
    note(grouped(image.clipped_pixels) + " pixels are too bright and were clipped; --exposure " +
         text_of(fitting_exposure(framebuffer)) + " would keep them all");
  std::cout << options.output_file().string() << ": " << picture.width << " x " << picture.height
            << " pixels, " << grouped(stats.triangles)
            << (stats.triangles == 1 ? " triangle, " : " triangles, ")
            << std::max(1L, std::lround(1e3 * stats.wall_seconds)) << " ms\n";
  for (const std::filesystem::path& aov : options.aov_files())
    std::cout << aov.string() << ": depth, normals, ids, parts and cost\n";
  if (options.wants_cost_picture())
    std::cout << cost_file(options.output_file()).string() << ": what was done for each pixel\n";
}

FrameStats draw(const Scene& scene, const Camera& camera, RenderSettings settings,
                Framebuffer& framebuffer) {
  ProgressBar bar;
  settings.progress = [&bar](double share) { bar.show(share); };
  return render(scene, camera, settings, framebuffer);
}

void render_picture(const RenderOptions& options) {
  const Description description = describe(options.input, options.given());
  const Picture& picture = description.picture;
  RenderSettings settings = picture.render_settings();
  settings.skips = options.skips();
  check_targets(options, picture);

  Scene scene = make_scene(description);
  print_warnings(scene);
  print_missing_texcoords(scene);
  const double aspect = double(picture.width) / picture.height;
  const Camera camera = make_camera(description.view, scene, aspect);
  scene.lights = make_lights(description, camera);

  const bool all = !options.aov_files().empty(), cost = options.wants_cost_picture();
  Framebuffer framebuffer(
      picture.width, picture.height,
      {.depth = all, .normal = all, .ids = all, .parts = all, .cost = all || cost});
  const FrameStats stats = draw(scene, camera, settings, framebuffer);
  const HoldInterrupts until_written;
  const ImageReport image = write_image(options.output_file(), framebuffer, picture.image);
  for (const std::filesystem::path& aov : options.aov_files()) write_aovs(aov, framebuffer);
  if (cost) write_image(cost_file(options.output_file()), draw_cost(framebuffer, settings.samples));
  report_picture(options, picture, stats, image, framebuffer);
  if (options.stats) print_stats(std::cout, stats, scene, settings.skips);
}

}  // namespace

Command add_render_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("render", "Draws a mesh, a built-in shape or a scene");
  std::ostringstream footer;
  footer << "Examples:\n"
            "  scanlit render teapot:16 --shading gouraud -o teapot.png\n"
            "  scanlit render bunny.obj --model blinn-phong:ks=.4,n=50 --samples 16\n"
            "  scanlit render scene.toml --aov scene.exr --stats\n"
            "  scanlit render scene.toml --aov cost --skip-off hidden-triangles -o all.png\n"
            "\n"
            "--aov cost draws beside the picture, all-cost.png, what was done for each pixel.\n"
            "--skip-off does what is left out otherwise, for the same picture; --aov cost and\n"
            "--stats show what that saves. Either may be given several times. Its NAMEs:\n";
  print_wrapped(footer, switch_names(), "  ");
  footer << "\n"
            "A scene file, in which everything but the mesh may be left out:\n"
         << scene_example
         << "\n\nColours are linear, .8,.2,.1 or one number for grey. In brackets: defaults.";
  app->footer(footer.str());
  const auto options = std::make_shared<RenderOptions>();
  add_render_options(*app, *options);
  return {app, [options] { render_picture(*options); }};
}

}  // namespace scanlit::studio
