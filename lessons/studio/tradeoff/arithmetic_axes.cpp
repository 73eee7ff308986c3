// What digits, powers, normals and divisions by w cost and bring, in the textbook renderer, with
// the engine beside it; and what the engine saves where it may be off. Against the reference, in
// double, of the same triangles.
#include "lessons/studio/text.h"
#include "lessons/studio/tradeoff/axes.h"
#include "lessons/studio/tradeoff/by_hand.h"
#include "lessons/studio/tradeoff/study_scene.h"
#include "lessons/studio/tradeoff/textbook.h"

namespace scanlit::studio {
namespace {

using Study = std::shared_ptr<const StudyScene>;

const ByHand by_hand{{0.5, 0.47, 0.42}, 0.4, 60};  // study_model

template <class T>
Candidate textbook(const Study& study, const std::string& series, const std::string& label,
                   const ByHand& reflection, const TextbookOptions& options) {
  struct State {
    Study study;
    ByHand reflection;
    Textbook<T, ByHand> renderer;
    std::vector<Rgb<T>> colour{};

    State(const Study& s, const ByHand& r, const TextbookOptions& o)
        : study(s), reflection(r), renderer(study->scene, study->camera, o, reflection) {}
    void draw() { renderer.draw(study_width, study_height, colour); }
  };
  const auto state = std::make_shared<State>(study, reflection, options);
  return {.series = series,
          .label = label,
          .triangles = std::int64_t(study->scene.objects[0].mesh->triangle_count()),
          .draw = [state] { state->draw(); },
          .picture =
              [state] {
                state->draw();
                ExactPicture picture(study_width, study_height, Rgb<double>());
                for (std::size_t i = 0; i < picture.pixel_count(); ++i)
                  picture.colour[i] = state->colour[i] * 1.0;
                return picture;
              }};
}

}  // namespace

std::vector<Measured> sweep_arithmetic(const Progress& progress) {
  const auto study = std::make_shared<StudyScene>(study_scene(study_shape));
  ByHand fast = by_hand;
  fast.fast_power = true;
  const std::string scalar = "textbook renderer";
  std::vector<Candidate> candidates{
      textbook<double>(study, scalar, "double", by_hand, {}),
      textbook<float>(study, scalar, "float", by_hand, {}),
      textbook<float>(study, scalar, "float, Schlick's power", fast, {}),
      textbook<float>(study, scalar, "float, normals not normalised", by_hand,
                      {.normalise = false}),
      textbook<float>(study, scalar, "float, neither", fast, {.normalise = false}),
      engine_candidate(std::make_shared<Renderer>(), study, "the engine", "float vectors")};
  candidates.back().is_default = true;
  return measure(candidates, reference_of(*study), progress);
}

std::vector<Measured> sweep_perspective(const Progress& progress) {
  const auto study = std::make_shared<StudyScene>(wall_scene());
  const auto every = [&](int pixels, const std::string& label) {
    return textbook<float>(study, "textbook renderer", label, by_hand,
                           {.perspective_every = pixels});
  };
  const auto renderer = std::make_shared<Renderer>();
  std::vector<Candidate> candidates{
      every(1, "at every pixel"),
      every(8, "every 8 pixels"),
      every(16, "every 16 pixels"),
      every(0, "affine"),
      engine_candidate(renderer, study, "the engine", "at every pixel"),
      engine_candidate(renderer, study, "the engine", "affine",
                       {.interpolation = Interpolation::screen_linear})};
  candidates[4].is_default = true;
  return measure(candidates, reference_of(*study), progress);
}

std::vector<Measured> sweep_tolerance(const Progress& progress) {
  const auto study = std::make_shared<StudyScene>(lights_scene());
  const auto renderer = std::make_shared<Renderer>();
  std::vector<Candidate> candidates;
  for (const double steps : {0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
    candidates.push_back(engine_candidate(renderer, study, "the engine",
                                          "tolerance " + text_of(steps), {.tolerance = steps}));
  candidates[0].is_default = true;
  return measure(candidates, reference_of(*study), progress);
}

}  // namespace scanlit::studio
