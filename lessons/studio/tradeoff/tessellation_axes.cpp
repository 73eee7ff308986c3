// Flat, Gouraud and Phong shading of meshes from coarse to fine, against the surface itself.
#include "lessons/studio/text.h"
#include "lessons/studio/tradeoff/axes.h"
#include "lessons/studio/tradeoff/study_scene.h"
#include "rasterizer/reference/analytic.h"

namespace scanlit::studio {
namespace {

struct Sweep {
  std::string shape;
  std::vector<int> sizes;
  int default_size, finest;  // the finest mesh tells the true surface where to look
};

std::vector<Candidate> candidates_of(const Sweep& sweep, const ExactPicture& truth) {
  const auto renderer = std::make_shared<Renderer>();
  std::vector<Candidate> candidates;
  for (const int size : sweep.sizes) {
    const StudyScene study = study_scene(sweep.shape + ":" + std::to_string(size));
    // Which pixels are near an edge is the same for all three.
    const auto edges = silhouettes(truth, reference_of(study), study.camera);
    for (const auto& [series, shading] :
         {std::pair("flat", Shading::flat), std::pair("Gouraud", Shading::gouraud),
          std::pair("Phong", Shading::phong)}) {
      const auto shaded = std::make_shared<StudyScene>(study);
      shaded->scene.objects[0].shading = shading;
      const std::int64_t triangles = std::int64_t(study.scene.objects[0].mesh->triangle_count());
      Candidate c = engine_candidate(renderer, shaded, series, grouped(triangles) + " triangles");
      c.is_default = size == sweep.default_size && shading == Shading::phong;
      c.silhouette = edges;
      candidates.push_back(std::move(c));
    }
  }
  return candidates;
}

std::vector<Measured> run(const Sweep& sweep, const Progress& progress) {
  const StudyScene finest = study_scene(sweep.shape + ":" + std::to_string(sweep.finest));
  const ExactPicture truth =
      render_analytic(finest.scene, finest.camera, study_width, study_height);
  return measure(candidates_of(sweep, truth), truth, progress);
}

}  // namespace

std::vector<Measured> sweep_teapot(const Progress& progress) {
  return run({"teapot", {2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64}, 8, 64}, progress);
}

std::vector<Measured> sweep_sphere(const Progress& progress) {
  return run({"sphere", {5, 9, 16, 28, 50, 90, 158, 281, 500}, 16, 158}, progress);
}

}  // namespace scanlit::studio
