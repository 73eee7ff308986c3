// Asks your functions what the judge wants to know. Yours is phong.h alone.
#include "phong.h"
#include "questions.h"

namespace {

using namespace a5;
using namespace scanlit;
using namespace scanlit::answer;

template <class T = double>
Vec3<T> vector(Received& question) {
  const double x = question.real(), y = question.real(), z = question.real();
  return {T(x), T(y), T(z)};
}
Rgb<double> colour(Received& question) {
  const double r = question.real(), g = question.real(), b = question.real();
  return {r, g, b};
}
void put(Sent& answer, const Vec3<double>& value) {
  answer::put(answer, value.x), answer::put(answer, value.y), answer::put(answer, value.z);
}
using answer::put;

/// Normal, light and viewer, and the exponents that belong to them.
template <class T>
struct Point {
  Vec3<T> normal, light, viewer;
  T phong_exponent, blinn_exponent;

  explicit Point(Received& question)
      : normal(vector<T>(question)), light(vector<T>(question)), viewer(vector<T>(question)) {
    phong_exponent = T(question.real()), blinn_exponent = T(question.real());
  }
};

template <class T = double, class Reply>
void for_each_point(Received& question, Sent& answer, const Reply& reply) {
  for (std::int64_t left = question.integer(); left > 0; --left)
    put(answer, reply(Point<T>(question)));
}

void phong_exponent(Received&, Sent& answer) { put(answer, Phong::phong_exponent()); }
void blinn_exponent(Received&, Sent& answer) { put(answer, Phong::blinn_exponent()); }
void half_vector(Received& question, Sent& answer) {
  for_each_point(question, answer,
                 [](const auto& p) { return Phong::half_vector(p.light, p.viewer); });
}
void mirrored(Received& question, Sent& answer) {
  for_each_point(question, answer,
                 [](const auto& p) { return Phong::mirrored(p.normal, p.light); });
}
void diffuse(Received& question, Sent& answer) {
  for_each_point(question, answer, [](const auto& p) { return Phong::diffuse(p.normal, p.light); });
}
template <class T>
T phong_at(const Point<T>& p) {
  return Phong::phong(p.normal, p.light, p.viewer, p.phong_exponent);
}
template <class T>
T blinn_at(const Point<T>& p) {
  return Phong::blinn(p.normal, p.light, p.viewer, p.blinn_exponent);
}
void phong(Received& question, Sent& answer) {
  for_each_point(question, answer, [](const auto& p) { return phong_at(p); });
}
void blinn(Received& question, Sent& answer) {
  for_each_point(question, answer, [](const auto& p) { return blinn_at(p); });
}

Lamp lamp(Received& question) {
  const double ambient = question.real(), intensity = question.real();
  return {ambient, intensity, colour(question)};
}
Tinted tinted_surface(Received& question) {
  const Rgb<double> ka = colour(question), kd = colour(question), ks = colour(question);
  return {ka, kd, ks};
}
Plastic plastic_surface(Received& question) {
  const double ka = question.real(), kd = question.real(), ks = question.real();
  return {ka, kd, ks, colour(question)};
}
void tinted(Received& question, Sent& answer) {
  for (std::int64_t left = question.integer(); left > 0; --left) {
    const Tinted surface = tinted_surface(question);
    const Lamp light = lamp(question);
    const double diffuse = question.real(), glossy = question.real();
    put(answer, Phong::tinted(surface, light, diffuse, glossy));
  }
}
void plastic(Received& question, Sent& answer) {
  for (std::int64_t left = question.integer(); left > 0; --left) {
    const Plastic surface = plastic_surface(question);
    const Lamp light = lamp(question);
    const double diffuse = question.real(), glossy = question.real();
    put(answer, Phong::plastic(surface, light, diffuse, glossy));
  }
}

/// In float: all of it, as the colour that the engine is to add for its one white light.
void tinted_picture(Received& question, Sent& answer) {
  const Rgb<double> kd(.1, .3, .6), ks(.5);
  for_each_point<float>(question, answer, [&](const auto& p) {
    const float d = Phong::diffuse(p.normal, p.light);
    const Rgb<float> I = Phong::tinted({kd, kd, ks}, {0, 1, Rgb<double>(1)}, d, phong_at(p));
    return Reflection<float>{.diffuse = {}, .glossy = I};
  });
}
void plastic_picture(Received& question, Sent& answer) {
  const Plastic surface{.1, .7, .5, {.9, .25, .1}};
  for_each_point<float>(question, answer, [&](const auto& p) {
    const float d = Phong::diffuse(p.normal, p.light);
    const Rgb<float> I = Phong::plastic(surface, {0, 1, Rgb<double>(1)}, d, blinn_at(p));
    return Reflection<float>{.diffuse = {}, .glossy = I};
  });
}

}  // namespace

int main() {
  return serve({{ask_phong_exponent, phong_exponent},
                {ask_blinn_exponent, blinn_exponent},
                {ask_half_vector, half_vector},
                {ask_mirrored, mirrored},
                {ask_diffuse, diffuse},
                {ask_phong, phong},
                {ask_blinn, blinn},
                {ask_tinted, tinted},
                {ask_plastic, plastic},
                {ask_tinted_picture, tinted_picture},
                {ask_plastic_picture, plastic_picture}});
}
