// What Fresnel reflectance costs as physics has it and as renderers have it, and what tables of a
// model cost and lose. Against the reference, in double, of the same triangles.
#include <algorithm>

#include "lessons/studio/text.h"
#include "lessons/studio/tradeoff/axes.h"
#include "lessons/studio/tradeoff/spectral_metal.h"
#include "lessons/studio/tradeoff/study_scene.h"
#include "lessons/studio/tradeoff/temporary_folder.h"
#include "models/measured/tabulate.h"
#include "models/metals.h"
#include "models/registry.h"

namespace scanlit::studio {
namespace {

constexpr const char* series = "the engine";

using Model = std::shared_ptr<const ReflectionModel>;

std::shared_ptr<StudyScene> with_model(const StudyScene& study, const Model& model) {
  auto result = std::make_shared<StudyScene>(study);
  result->scene.objects[0].material.model = model;
  return result;
}

std::string facets(const std::string& fresnel) { return "cook-torrance:m=.35,F=" + fresnel; }

/// The metal's index at one wavelength for each channel, as the lecture simplifies it: those of
/// sRGB's primaries (IEC 61966-2-1), by their dominant wavelengths.
std::string three_wavelengths(const models::Metal& metal) {
  const models::OpticalConstants r = metal.at(611), g = metal.at(549), b = metal.at(464);
  return facets("conductor") + ",eta=" + text_of(Rgb<double>{r.n, g.n, b.n}) +
         ",k=" + text_of(Rgb<double>{r.k, g.k, b.k});
}

std::string schlick(const models::Metal& metal) {
  const Rgb<double> f0 = models::spectral_rgb(metal, 1);
  const auto shown = [](double c) { return std::clamp(c, 0.0, 1.0); };
  return facets("schlick") + ",f0=" + text_of(Rgb<double>{shown(f0.r), shown(f0.g), shown(f0.b)});
}

}  // namespace

std::vector<Measured> sweep_fresnel(const Progress& progress) {
  const models::Metal& copper = models::find_metal("copper");
  const StudyScene study = study_scene(study_shape);
  const Model spectral =
      std::make_shared<SpectralMetal>(models::make(facets("one")).model, "copper");
  const auto renderer = std::make_shared<Renderer>();
  std::vector<Candidate> candidates;
  const auto add = [&](const std::string& label, const Model& model) {
    candidates.push_back(engine_candidate(renderer, with_model(study, model), series, label));
  };
  add("81 wavelengths", spectral);
  add("exact at 3 wavelengths", models::make(three_wavelengths(copper)).model);
  add("fit of the spectral colour", models::make(facets("copper")).model);
  add("Schlick", models::make(schlick(copper)).model);
  add("none, F = 1", models::make(facets("one")).model);
  candidates[2].is_default = true;
  return measure(candidates, reference_of(*with_model(study, spectral)), progress);
}

std::vector<Measured> sweep_tables(const Progress& progress) {
  const Model formula = models::make(std::string(study_model) + ",normalised=1").model;
  const StudyScene study = study_scene(study_shape);
  const TemporaryFolder folder;
  const std::string merl = folder.file("merl.binary"), utia = folder.file("utia.bin");
  models::tabulate_merl(*formula, merl);
  models::tabulate_utia(*formula, utia);
  const auto renderer = std::make_shared<Renderer>();
  std::vector<Candidate> candidates;
  const auto add = [&](const std::string& label, const Model& model) {
    candidates.push_back(engine_candidate(renderer, with_model(study, model), series, label));
  };
  add("formula", formula);
  add("MERL table, nearest entry", models::make("merl:lookup=nearest,file=" + merl).model);
  add("MERL table, trilinear", models::make("merl:file=" + merl).model);
  add("UTIA table", models::make("utia:file=" + utia).model);
  candidates[0].is_default = true;
  return measure(candidates, reference_of(*with_model(study, formula)), progress);
}

}  // namespace scanlit::studio
