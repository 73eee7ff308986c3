// Pictures of a reflection model that is asked for, point by point, and their comparison.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/model_questions.h"
#include "rasterizer/scene.h"

namespace scanlit::assignments {

/// The ordinary model interface, onto a formula of directions; visible points whose normal faces
/// away from the viewer are taken for just visible (min_n_v).
class DirectionsModel : public ReflectionModel {
 public:
  Needs needs() const override { return {.frame = true}; }
  using ReflectionModel::evaluate;
  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override;
  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point) const override;
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point) const override;

 private:
  /// pi f_r (N.L) for each.
  virtual std::vector<Reflection<double>> reflect(const std::vector<Directions>& all) const = 0;
};

/// By the judge's own formula.
class ReferenceModel final : public DirectionsModel {
 public:
  using Formula = std::function<Reflection<double>(const Directions&)>;
  explicit ReferenceModel(Formula formula) : formula_(std::move(formula)) {}

 private:
  std::vector<Reflection<double>> reflect(const std::vector<Directions>& all) const override;
  Formula formula_;
};

/// By the student's: each span is one question, answered by six finite numbers a pair, diffuse and
/// glossy. `braces` makes pi f_r (N.L) of what is answered.
class AskedModel final : public DirectionsModel {
 public:
  using Ask = std::function<Values(const std::vector<Directions>&)>;
  using Braces = std::function<Reflection<double>(const Directions&, const Reflection<double>&)>;
  AskedModel(Ask ask, Braces braces) : ask_(std::move(ask)), braces_(std::move(braces)) {}
  /// Pairs of directions are all that is asked.
  AskedModel(Respondent& student, int kind, Braces braces);

 private:
  std::vector<Reflection<double>> reflect(const std::vector<Directions>& all) const override;
  Ask ask_;
  Braces braces_;
};

/// What is drawn: a shape, lit from the upper left and from the right, 320 x 240.
struct ModelPicture {
  std::string name, title;  // as JudgedPicture
  std::string shape = "teapot:10";
  Rgb<double> ka{0};
  ColourForm form = ColourForm::tinted;
  Rgb<double> object_colour{1}, light_colour{1};
  Tangents tangents{};
  double brightness = 1;  // of both lights
};

/// For a page: JudgedPicture::fresh alone.
JudgedPicture drawn(const ModelPicture& picture, std::shared_ptr<const ReflectionModel> model);

/// Draws both, adds them to the verdict's pictures, and compares: right where no more than 1 of 200
/// pixels are off by more than 2 of 255 codes. Throws Unanswered.
Finding compare_pictures(Examination& e, const ModelPicture& picture,
                         std::shared_ptr<const ReflectionModel> reference,
                         std::shared_ptr<const ReflectionModel> fresh);

}  // namespace scanlit::assignments
