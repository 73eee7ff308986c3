// Asks your functions what the judge wants to know. Yours is shading.cpp alone.
#include "answer/serve.h"
#include "questions.h"

namespace {

using namespace a4;
using scanlit::answer::ask_judge;
using scanlit::answer::Received;
using scanlit::answer::Sent;

// Braces are evaluated from left to right.
Vector vector(Received& from) { return {from.real(), from.real(), from.real()}; }
Weights weights(Received& from) { return {{from.real(), from.real(), from.real()}}; }
Vertex vertex(Received& from) { return {vector(from), vector(from)}; }

Scene scene(Received& from) {
  Scene s{vector(from), {}, vector(from), vector(from), from.real(), from.real()};
  for (std::int64_t i = from.integer(); i > 0; --i)
    s.lights.push_back({vector(from), vector(from)});
  return s;
}

// ------------------------------------------------------------------------- the judge's own stages

Vector asked(Question kind, const Sent& question) {
  Received answer = ask_judge(kind, question);
  return vector(answer);
}

const Stages right{[](Vector normal, Vector to_viewer, const Scene& s) {
                     Sent question;
                     put(normal, question), put(to_viewer, question), put(s, question);
                     return asked(ask_light, question);
                   },
                   [](const Vector (&corners)[3], const Weights& w) {
                     Sent question;
                     for (const Vector& corner : corners) put(corner, question);
                     put(w, question);
                     return asked(ask_interpolate, question);
                   },
                   [](const Vector (&normals)[3], const Weights& w) {
                     Sent question;
                     for (const Vector& normal : normals) put(normal, question);
                     put(w, question);
                     return asked(ask_normal, question);
                   }};

const Stages own{light, interpolate, interpolate_normal};

// -------------------------------------------------------------------------------------- questions

void answer_light(Received& q, Sent& to) {
  const Vector normal = vector(q), to_viewer = vector(q);
  put(light(normal, to_viewer, scene(q)), to);
}

void answer_vertex(Received& q, Sent& to) {
  const Vertex v = vertex(q);
  put(shade_vertex(v, scene(q), right), to);
}

void answer_interpolate(Received& q, Sent& to) {
  const Vector corners[3] = {vector(q), vector(q), vector(q)};
  put(interpolate(corners, weights(q)), to);
}

void answer_normal(Received& q, Sent& to) {
  const Vector normals[3] = {vector(q), vector(q), vector(q)};
  put(interpolate_normal(normals, weights(q)), to);
}

void answer_fragment(Received& q, Sent& to) {
  const Vertex triangle[3] = {vertex(q), vertex(q), vertex(q)};
  const Weights w = weights(q);
  put(shade_fragment(triangle, w, scene(q), right), to);
}

// A row of fragments of one triangle, by your functions alone.

void answer_gouraud_span(Received& q, Sent& to) {
  const Vertex triangle[3] = {vertex(q), vertex(q), vertex(q)};
  const Scene s = scene(q);
  const Colour corners[3] = {shade_vertex(triangle[0], s, own), shade_vertex(triangle[1], s, own),
                             shade_vertex(triangle[2], s, own)};
  for (std::int64_t i = q.integer(); i > 0; --i) put(interpolate(corners, weights(q)), to);
}

void answer_phong_span(Received& q, Sent& to) {
  const Vertex triangle[3] = {vertex(q), vertex(q), vertex(q)};
  const Scene s = scene(q);
  for (std::int64_t i = q.integer(); i > 0; --i)
    put(shade_fragment(triangle, weights(q), s, own), to);
}

}  // namespace

int main() {
  return scanlit::answer::serve({{ask_light, answer_light},
                                 {ask_vertex, answer_vertex},
                                 {ask_interpolate, answer_interpolate},
                                 {ask_normal, answer_normal},
                                 {ask_fragment, answer_fragment},
                                 {ask_gouraud_span, answer_gouraud_span},
                                 {ask_phong_span, answer_phong_span}});
}
