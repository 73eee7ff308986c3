// Runs your tests when the judge asks for it. Yours is mutant_hunt.cpp alone.
#include "answer/serve.h"
#include "mutant_hunt.h"
#include "questions.h"

namespace {

using a9::ask_count, a9::ask_run, a9::ask_stage;

struct Failed {};

}  // namespace

namespace a9 {

void check(bool condition) {
  if (!condition) throw Failed{};
}

std::vector<Fragment> scan_convert(const Triangle& triangle, int width, int height) {
  scanlit::answer::Sent question;
  for (const Point& p : triangle.corners)
    question.integers.insert(question.integers.end(), {p.x, p.y});
  question.integers.insert(question.integers.end(), {width, height});
  scanlit::answer::Received answer = scanlit::answer::ask_judge(ask_stage, question);
  std::vector<Fragment> fragments(answer.integers.size() / 2);
  for (Fragment& f : fragments) f = {int(answer.integer()), int(answer.integer())};
  return fragments;
}

}  // namespace a9

namespace {

using scanlit::answer::Received;
using scanlit::answer::Sent;

void count(Received&, Sent& answer) { answer.integers = {std::int64_t(a9::tests().size())}; }

void run(Received& question, Sent& answer) {
  const a9::Test& test = a9::tests().at(std::size_t(question.integer()));
  try {
    test.run();
    answer.integers = {1};
  } catch (const Failed&) {
    answer.integers = {0};
  }
}

}  // namespace

int main() { return scanlit::answer::serve({{ask_count, count}, {ask_run, run}}); }
