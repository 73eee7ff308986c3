// Asks your functions what the judge wants to know. Yours is cook_torrance.h alone.
#include "cook_torrance.h"
#include "questions.h"

namespace {

using namespace a6;
using namespace scanlit;
using namespace scanlit::answer;

const CookTorrance model;

/// m comes along with each pair of directions.
template <class Reply>
void for_each_with_m(Received& question, Sent& answer, const Reply& reply) {
  for (std::int64_t left = question.integer(); left > 0; --left) {
    const Pair<double> p = pair(question);
    put(answer, reply(p.cosines, question.real()));
  }
}

void m(Received&, Sent& answer) { put(answer, CookTorrance::m()); }
void D(Received& question, Sent& answer) {
  for_each_with_m(question, answer, [](const auto& c, double m) { return model.D(c, m); });
}
void G(Received& question, Sent& answer) {
  for_each_with_m(question, answer, [](const auto& c, double m) { return model.G(c, m); });
}
void F(Received& question, Sent& answer) {
  for_each_pair(question, answer, [](const auto& p) { return model.F(p.cosines); });
}
void product(Received& question, Sent& answer) {
  for (std::int64_t left = question.integer(); left > 0; --left) {
    const Pair<double> p = pair(question);
    const double D = question.real(), G = question.real();
    const double r = question.real(), g = question.real(), b = question.real();
    put(answer, model.product(D, G, Rgb<double>(r, g, b), p.cosines));
  }
}
void whole(Received& question, Sent& answer) {
  for_each_pair(question, answer, [](const auto& p) { return model(p.cosines); });
}
/// In float, and as the engine's model interface has it.
void picture(Received& question, Sent& answer) {
  for_each_pair<float>(question, answer, [](const auto& p) {
    return Reflection<float>{.diffuse = {}, .glossy = model(p.cosines)};
  });
}

}  // namespace

int main() {
  return serve({{ask_m, m},
                {ask_D, D},
                {ask_G, G},
                {ask_F, F},
                {ask_product, product},
                {ask_model, whole},
                {ask_picture, picture}});
}
