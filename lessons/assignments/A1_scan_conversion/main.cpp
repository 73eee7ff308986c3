// Asks your functions what the judge wants to know. Yours is scan_conversion.cpp alone.
#include "answer/serve.h"
#include "questions.h"

namespace {

using namespace a1;
using scanlit::answer::ask_judge;
using scanlit::answer::Received;
using scanlit::answer::Sent;

// Braces are evaluated from left to right.
Point point(Received& from) { return {from.integer(), from.integer()}; }
Edge edge(Received& from) {
  return {from.integer(), from.integer(), from.integer(), from.integer() != 0};
}
struct Edges {
  Edge all[3];
};
Edges edges(Received& from) { return {{edge(from), edge(from), edge(from)}}; }

// ------------------------------------------------------------------------- the judge's own stages

const Stages right{[](Point from, Point to, Point third) {
                     Sent question;
                     put(from, question), put(to, question), put(third, question);
                     Received answer = ask_judge(ask_edge, question);
                     return edge(answer);
                   },
                   [](const Edge& e) {
                     Sent question;
                     put(e, question);
                     return ask_judge(ask_owns, question).integer() != 0;
                   },
                   [](const Edge (&e)[3], int column, int row) {
                     Sent question;
                     put(e, question);
                     question.integers.insert(question.integers.end(), {column, row});
                     return ask_judge(ask_covers, question).integer() != 0;
                   },
                   [](const Edge (&e)[3], int row, int width) {
                     Sent question;
                     put(e, question);
                     question.integers.insert(question.integers.end(), {row, width});
                     Received answer = ask_judge(ask_span, question);
                     return Span{int(answer.integer()), int(answer.integer())};
                   }};

const Stages own{a1::edge, owns, covers, span};

// -------------------------------------------------------------------------------------- questions

void answer_edge(Received& q, Sent& to) {
  const Point from = point(q), end = point(q), third = point(q);
  put(a1::edge(from, end, third), to);
}

void answer_owns(Received& q, Sent& to) { to.integers.push_back(owns(edge(q))); }

void answer_covers(Received& q, Sent& to) {
  const Edges e = edges(q);
  const int column = int(q.integer()), row = int(q.integer());
  to.integers.push_back(covers(e.all, column, row));
}

void answer_span(Received& q, Sent& to) {
  const Edges e = edges(q);
  const int row = int(q.integer()), width = int(q.integer());
  const Span s = span(e.all, row, width);
  to.integers = {s.begin, s.end};
}

void answer_scan_convert(Received& q, Sent& to) {
  const bool alone = q.integer() != 0;
  const Picture picture{int(q.integer()), int(q.integer())};
  const Triangle triangle{{point(q), point(q), point(q)}};
  std::vector<Fragment> fragments;
  scan_convert(triangle, picture, alone ? right : own, fragments);
  for (const Fragment& f : fragments) to.integers.insert(to.integers.end(), {f.column, f.row});
}

}  // namespace

int main() {
  return scanlit::answer::serve({{ask_edge, answer_edge},
                                 {ask_owns, answer_owns},
                                 {ask_covers, answer_covers},
                                 {ask_span, answer_span},
                                 {ask_scan_convert, answer_scan_convert}});
}
