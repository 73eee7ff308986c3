// Asks your functions what the judge wants to know. Yours is clipping.cpp alone.
#include "answer/serve.h"
#include "questions.h"

namespace {

using namespace a2;
using scanlit::answer::ask_judge;
using scanlit::answer::Received;
using scanlit::answer::Sent;

// Braces are evaluated from left to right.
Vertex vertex(Received& from) {
  return {
      from.real(), from.real(), from.real(), from.real(), {from.real(), from.real(), from.real()}};
}
Weights weights(Received& from) { return {{from.real(), from.real(), from.real()}}; }
Polygon polygon(Received& from) {
  Polygon p;
  for (std::size_t i = 0; i < from.reals.size() / 7; ++i) p.push_back(vertex(from));
  return p;
}

// ------------------------------------------------------------------------- the judge's own stages

const Stages right{[](const Vertex& v, Plane plane) {
                     Sent question;
                     put(v, question);
                     question.integers.push_back(int(plane));
                     return ask_judge(ask_distance, question).real();
                   },
                   [](const Vertex& inside, const Vertex& outside, double d_in, double d_out) {
                     Sent question;
                     put(inside, question), put(outside, question);
                     question.reals.insert(question.reals.end(), {d_in, d_out});
                     Received answer = ask_judge(ask_cut, question);
                     return vertex(answer);
                   },
                   [](const Polygon& p, Plane plane) {
                     Sent question;
                     put(p, question);
                     question.integers.push_back(int(plane));
                     Received answer = ask_judge(ask_clip, question);
                     return polygon(answer);
                   }};

Polygon own_clip(const Polygon& p, Plane plane);
const Stages own{distance, cut, own_clip};
Polygon own_clip(const Polygon& p, Plane plane) { return clip(p, plane, own); }

// -------------------------------------------------------------------------------------- questions

void answer_distance(Received& q, Sent& to) {
  to.reals.push_back(distance(vertex(q), Plane(q.integer())));
}

void answer_cut(Received& q, Sent& to) {
  const Vertex inside = vertex(q), outside = vertex(q);
  const double d_inside = q.real(), d_outside = q.real();
  put(cut(inside, outside, d_inside, d_outside), to);
}

void answer_clip(Received& q, Sent& to) {
  const Polygon p = polygon(q);
  put(clip(p, Plane(q.integer()), right), to);
}

void answer_triangle(Received& q, Sent& to) {
  const Vertex triangle[3] = {vertex(q), vertex(q), vertex(q)};
  put(clip_triangle(triangle, right), to);
}

void answer_whole_triangle(Received& q, Sent& to) {
  const Vertex triangle[3] = {vertex(q), vertex(q), vertex(q)};
  put(clip_triangle(triangle, own), to);
}

/// Of one fragment, or of a row of them.
void answer_perspective(Received& q, Sent& to) {
  const double corner_w[3] = {q.real(), q.real(), q.real()};
  for (std::int64_t i = q.integer(); i > 0; --i) put(perspective(weights(q), corner_w), to);
}

}  // namespace

int main() {
  return scanlit::answer::serve({{ask_distance, answer_distance},
                                 {ask_cut, answer_cut},
                                 {ask_clip, answer_clip},
                                 {ask_triangle, answer_triangle},
                                 {ask_perspective, answer_perspective},
                                 {ask_whole_triangle, answer_whole_triangle},
                                 {ask_perspective_span, answer_perspective}});
}
