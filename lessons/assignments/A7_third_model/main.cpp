// Asks your functions what the judge wants to know. Yours is third_model.h alone.
#include "questions.h"
#include "third_model.h"

namespace {

using namespace a7;
using namespace scanlit;
using namespace scanlit::answer;

template <class T>
Rgb<T> grey(const T& value) {
  return Rgb<T>(value);
}
template <class T>
Rgb<T> grey(const Rgb<T>& value) {
  return value;
}
Rgb<double> colour(Received& question) {
  const double r = question.real(), g = question.real(), b = question.real();
  return {r, g, b};
}
template <class First>
First first_as(const Rgb<double>& colour) {
  if constexpr (std::is_same_v<First, double>)
    return colour.r;
  else
    return colour;
}

template <class Model>
struct Asks {
  static void first(Received& question, Sent& answer) {
    for_each_pair(question, answer,
                  [](const auto& p) { return grey(Model::first(p.cosines, p.frame)); });
  }
  static void second(Received& question, Sent& answer) {
    for (std::int64_t left = question.integer(); left > 0; --left) {
      const Pair<double> p = pair(question);
      using First = decltype(Model::first(p.cosines, p.frame));
      put(answer, Model::second(first_as<First>(colour(question)), p.cosines, p.frame));
    }
  }
  static void model(Received& question, Sent& answer) {
    for_each_pair(question, answer, [](const auto& p) { return whole<Model>(p.cosines, p.frame); });
  }
  /// In float, and as the engine's model interface has it.
  static void picture(Received& question, Sent& answer) {
    for_each_pair<float>(question, answer, [](const auto& p) {
      return Reflection<float>{.diffuse = {}, .glossy = whole<Model>(p.cosines, p.frame)};
    });
  }
};

void chosen(Received&, Sent& answer) { put(answer, double(int(choice))); }
void what_is_returned(Received& question, Sent& answer) {
  for (std::int64_t left = question.integer(); left > 0; --left) {
    const Pair<double> p = pair(question);
    put(answer, returned(colour(question), p.cosines));
  }
}

template <class Model>
int serve_model() {
  return serve({{ask_choice, chosen},
                {ask_first, Asks<Model>::first},
                {ask_second, Asks<Model>::second},
                {ask_returned, what_is_returned},
                {ask_model, Asks<Model>::model},
                {ask_picture, Asks<Model>::picture}});
}

}  // namespace

int main() {
  if (choice == Choice::lafortune) return serve_model<Lafortune>();
  if (choice == Choice::oren_nayar) return serve_model<OrenNayar>();
  return serve_model<Ward>();
}
