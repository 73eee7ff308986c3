#include "lessons/assignments/judge/model_picture.h"

#include <algorithm>
#include <cmath>

#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/worded.h"
#include "rasterizer/render.h"
#include "rasterizer/shapes.h"

namespace scanlit::assignments {

namespace {

constexpr int width = 320, height = 240;
constexpr int tolerance_codes = 2;
constexpr int one_in = 200;

Vec3<double> at(const float* const (&arrays)[3], std::size_t i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

Vec3<double> unit(const Vec3<double>& a) { return a * (1 / std::sqrt(dot(a, a))); }

Framebuffer draw(const ModelPicture& picture, std::shared_ptr<const ReflectionModel> model) {
  const Material material{.model = std::move(model),
                          .ka = picture.ka,
                          .form = picture.form,
                          .object_colour = picture.object_colour,
                          .tangents = picture.tangents};
  const auto mesh = std::make_shared<const Mesh>(make_shape(picture.shape));
  const Scene scene{.objects = {{.mesh = mesh, .material = material, .name = picture.shape}},
                    .lights = {{.intensity = 1.2 * picture.brightness,
                                .colour = picture.light_colour,
                                .direction = {-.6, .9, .9}},
                               {.intensity = .6 * picture.brightness,
                                .colour = picture.light_colour,
                                .direction = {1, .2, .1}}},
                    .background = Rgb<double>(.01)};
  Camera camera = framed({.eye = {0.6, 1.8, 4}, .target = {0, -.1, 0}, .fov_deg = 30},
                         bounding_sphere(scene), double(width) / height);
  camera.fov_deg *= .75;  // the teapot is wider than high
  Framebuffer frame(width, height);
  render(scene, camera, {.threads = 1}, frame);
  return frame;
}

std::string colour_at(const std::vector<std::uint8_t>& codes, std::size_t pixel) {
  return worded("(%d, %d, %d)", codes[3 * pixel], codes[3 * pixel + 1], codes[3 * pixel + 2]);
}

}  // namespace

void DirectionsModel::evaluate(const DirectionSpan& in, const ReflectionSpan& out) const {
  std::vector<Directions> lit;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < in.size; ++i) {
    for (int c = 0; c < 3; ++c) out.diffuse[c][i] = out.glossy[c][i] = 0;
    const Vec3<double> n = unit(at(in.normal, i)), t = unit(at(in.tangent, i));
    const ShadingFrame<double> frame = shading_frame(n, t, at(in.to_light, i), at(in.to_viewer, i));
    Directions d{unit(frame.l), frame.v};
    if (!(d.l.z > 0)) continue;
    d.v.z = std::max(d.v.z, min_n_v);
    d.v = unit(d.v);
    lit.push_back(d), places.push_back(i);
  }
  const std::vector<Reflection<double>> values = reflect(lit);
  for (std::size_t k = 0; k < lit.size(); ++k) {
    const auto store = [i = places[k]](const Rgb<double>& from, float* const(&to)[3]) {
      to[0][i] = float(from.r), to[1][i] = float(from.g), to[2][i] = float(from.b);
    };
    store(values[k].diffuse, out.diffuse), store(values[k].glossy, out.glossy);
  }
}

Reflection<double> DirectionsModel::evaluate(const Vec3<double>& l, const Vec3<double>& v,
                                             const SurfacePoint<double>&) const {
  if (!(l.z > 0 && v.z > 0)) return {};
  return reflect({{l, v}})[0];
}

Reflection<float> DirectionsModel::evaluate(const Vec3<float>& l, const Vec3<float>& v,
                                            const SurfacePoint<float>&) const {
  const Reflection<double> value =
      evaluate({l.x, l.y, l.z}, {v.x, v.y, v.z}, SurfacePoint<double>{});
  return {value.diffuse * 1.0f, value.glossy * 1.0f};
}

std::vector<Reflection<double>> ReferenceModel::reflect(const std::vector<Directions>& all) const {
  std::vector<Reflection<double>> values;
  for (const Directions& d : all) values.push_back(formula_(d));
  return values;
}

AskedModel::AskedModel(Respondent& student, int kind, Braces braces)
    : AskedModel(
          [&student, kind](const std::vector<Directions>& all) {
            return ask_values(
                student,
                {.name = "", .kind = kind, .width = 6, .directions = all, .reference = {}});
          },
          std::move(braces)) {}

std::vector<Reflection<double>> AskedModel::reflect(const std::vector<Directions>& all) const {
  if (all.empty()) return {};
  const Values answer = ask_(all);
  std::vector<Reflection<double>> values;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double* const row = &answer[6 * i];
    if (!std::all_of(row, row + 6, [](double a) { return std::isfinite(a); }))
      throw Unanswered("In the picture a value is not finite: " + describe(Values(row, row + 6)) +
                       " with " + describe(all[i]) + ".");
    const auto clamped = [row](int k) { return std::clamp(row[k], -1e6, 1e6); };
    values.push_back(braces_(
        all[i], {{clamped(0), clamped(1), clamped(2)}, {clamped(3), clamped(4), clamped(5)}}));
  }
  return values;
}

JudgedPicture drawn(const ModelPicture& picture, std::shared_ptr<const ReflectionModel> model) {
  return {.name = picture.name,
          .title = picture.title,
          .width = width,
          .height = height,
          .fresh = codes_of(draw(picture, std::move(model))),
          .reference = {},
          .difference = {}};
}

Finding compare_pictures(Examination& e, const ModelPicture& picture,
                         std::shared_ptr<const ReflectionModel> reference,
                         std::shared_ptr<const ReflectionModel> fresh) {
  JudgedPicture both = judged(picture.name, picture.title, draw(picture, std::move(fresh)),
                              draw(picture, std::move(reference)));
  const auto first = first_difference(both, tolerance_codes);
  Finding finding;
  if (first && first->count * one_in > width * height) {
    const auto at = std::size_t(first->y * width + first->x);
    finding = Finding::wrong(
        worded("%s: %d of %d pixels are off by more than %d of 255 codes. The first:\n"
               "  x = %d, y = %d: yours is %s, should be %s",
               picture.title.c_str(), first->count, width * height, tolerance_codes, first->x,
               first->y, colour_at(both.fresh, at).c_str(), colour_at(both.reference, at).c_str()));
  }
  e.pictures.push_back(std::move(both));
  return finding;
}

}  // namespace scanlit::assignments
