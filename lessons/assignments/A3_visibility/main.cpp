// Asks your functions what the judge wants to know. Yours is visibility.cpp alone.
#include "answer/serve.h"
#include "questions.h"
#include "visibility.h"

namespace {

using namespace a3;
using scanlit::answer::ask_judge;
using scanlit::answer::Received;
using scanlit::answer::Sent;

// ------------------------------------------------------------------------- the judge's own stages

const Stages right{[](double depth) {
                     return StoredDepth(ask_judge(ask_stored, {{}, {depth}}).integer());
                   },
                   [] { return StoredDepth(ask_judge(ask_farthest, {}).integer()); },
                   [](StoredDepth fresh, StoredDepth there) {
                     return ask_judge(ask_replaces, {{fresh, there}, {}}).integer() != 0;
                   }};

// -------------------------------------------------------------------------------------- questions

// Braces are evaluated from left to right.
Corner corner(Received& from) { return {from.real(), from.real(), from.real()}; }

void answer_depth_of(Received& q, Sent& to) {
  const double distance = q.real(), near = q.real(), far = q.real();
  to.reals.push_back(depth_of(distance, near, far));
}

void answer_depth_at(Received& q, Sent& to) {
  const Corner triangle[3] = {corner(q), corner(q), corner(q)};
  const double x = q.real(), y = q.real();
  to.reals.push_back(depth_at(triangle, x, y));
}

void answer_stored(Received& q, Sent& to) { to.integers.push_back(stored(q.real())); }

void answer_farthest(Received&, Sent& to) { to.integers.push_back(farthest()); }

/// Of one fragment, or of a row of them.
void answer_replaces(Received& q, Sent& to) {
  for (std::size_t i = 0; i < q.integers.size(); i += 2)
    to.integers.push_back(replaces(StoredDepth(q.integers[i]), StoredDepth(q.integers[i + 1])));
}

void answer_draw(Received& q, Sent& to) {
  const int width = int(q.integer()), height = int(q.integer());
  std::vector<Fragment> fragments;
  for (std::size_t i = 0; i < q.reals.size(); ++i)
    fragments.push_back({int(q.integer()), int(q.integer()), q.real(), int(q.integer())});
  for (const int id : draw(fragments, width, height, right)) to.integers.push_back(id);
}

/// Fragments in a row, by your functions alone; corners with distances.
void answer_depth_span(Received& q, Sent& to) {
  const double near = q.real(), far = q.real();
  Corner triangle[3] = {corner(q), corner(q), corner(q)};
  for (Corner& each : triangle) each.depth = depth_of(each.depth, near, far);
  const std::int64_t column = q.integer(), row = q.integer(), count = q.integer();
  for (std::int64_t i = column; i < column + count; ++i)
    to.integers.push_back(stored(depth_at(triangle, double(i) + 0.5, double(row) + 0.5)));
}

}  // namespace

int main() {
  return scanlit::answer::serve({{ask_depth_of, answer_depth_of},
                                 {ask_depth_at, answer_depth_at},
                                 {ask_stored, answer_stored},
                                 {ask_farthest, answer_farthest},
                                 {ask_replaces, answer_replaces},
                                 {ask_draw, answer_draw},
                                 {ask_depth_span, answer_depth_span},
                                 {ask_test_span, answer_replaces}});
}
