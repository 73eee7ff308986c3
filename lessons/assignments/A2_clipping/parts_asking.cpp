// What is asked and said in the parts of A2.
#include <algorithm>
#include <cmath>

#include "lessons/assignments/A2_clipping/parts.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments::clipping {

Vertex vertex_of(const Numbers& answer, std::size_t number) {
  const double* const r = &answer.reals[7 * number];
  return {r[0], r[1], r[2], r[3], {r[4], r[5], r[6]}};
}
Polygon polygon_of(const Numbers& answer) {
  Polygon p;
  for (std::size_t i = 0; i < answer.reals.size() / 7; ++i) p.push_back(vertex_of(answer, i));
  return p;
}

std::string words(const Vertex& v) {
  const auto f = [](double x) { return studio::fixed(x, 4); };
  return "(x " + f(v.x) + ", y " + f(v.y) + ", z " + f(v.z) + ", w " + f(v.w) + "; attributes " +
         f(v.attribute[0]) + ", " + f(v.attribute[1]) + ", " + f(v.attribute[2]) + ")";
}
std::string words(const Polygon& p) {
  std::string text = p.empty() ? " nothing" : "";
  for (const Vertex& v : p) text += "\n    " + words(v);
  return text;
}
std::string words(const Weights& w) {
  return "(" + studio::fixed(w.corner[0], 5) + ", " + studio::fixed(w.corner[1], 5) + ", " +
         studio::fixed(w.corner[2], 5) + ")";
}

const char* name(Plane plane) {
  static constexpr const char* names[] = {"left", "right", "bottom", "top", "near", "far"};
  return names[int(plane)];
}

bool equal(const Vertex& a, const Vertex& b) {
  double off = std::max(
      {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z), std::abs(a.w - b.w)});
  for (int i = 0; i < 3; ++i) off = std::max(off, std::abs(a.attribute[i] - b.attribute[i]));
  return off <= 1e-7;  // coordinates are below 10: rounding errors of any order of operations
}

bool equal(Polygon a, Polygon b) {
  for (Polygon* p : {&a, &b}) {
    p->erase(std::unique(p->begin(), p->end(),
                         [](const Vertex& u, const Vertex& v) { return equal(u, v); }),
             p->end());
    while (p->size() > 1 && equal(p->front(), p->back())) p->pop_back();
    if (p->size() < 3) p->clear();
  }
  if (a.size() != b.size()) return false;
  for (std::size_t first = 0; first < std::max<std::size_t>(a.size(), 1); ++first) {
    if (std::ranges::equal(a, b, [](const Vertex& u, const Vertex& v) { return equal(u, v); }))
      return true;
    std::ranges::rotate(a, a.begin() + (a.empty() ? 0 : 1));
  }
  return false;
}

namespace {

Numbers right_answer(const ClipVariant& variant, int kind, const Numbers& question) {
  const std::size_t reals = question.reals.size();
  const bool with_plane =
      question.integers.size() == 1 && question.integers[0] >= 0 && question.integers[0] < 6;
  Numbers answer;
  if (kind == ask_distance && reals == 7 && with_plane) {
    answer.reals = {right_distance(variant, vertex_of(question), Plane(question.integers[0]))};
  } else if (kind == ask_cut && reals == 16) {
    put(right_cut(vertex_of(question, 0), vertex_of(question, 1), question.reals[14],
                  question.reals[15]),
        answer);
  } else if (kind == ask_clip && reals % 7 == 0 && reals <= 700 && with_plane) {
    put(right_clip(variant, polygon_of(question), Plane(question.integers[0])), answer);
  } else {
    throw Unanswered("your program asked back for what there is not");
  }
  for (double& number : answer.reals)
    if (!std::isfinite(number)) number = 0;  // of a cut where the edge does not cross
  return answer;
}

}  // namespace

Numbers ask(Examination& e, int kind, const Numbers& question, const AnswerSize& size) {
  return e.student.ask(kind, question, size, [&](int asked, const Numbers& numbers) {
    if (asked >= kind) throw Unanswered("your program asks back what it is asked itself");
    return right_answer(clip_variant(e.variant), asked, numbers);
  });
}

}  // namespace scanlit::assignments::clipping
