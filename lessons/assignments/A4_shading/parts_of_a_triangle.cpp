// A4.2 to A4.5: a vertex, what lies between vertices, a fragment.
#include "lessons/assignments/A4_shading/parts.h"

namespace scanlit::assignments::shading {

Finding test_vertex(Examination& e) {
  const ShadingVariant variant = shading_variant(e.variant);
  Dice dice(e.questions, "A4.2");
  for (int i = 0; i < 40; ++i) {
    const Scene scene = any_scene(dice, i % 2 ? 0.6 : 3);  // every other one is too bright
    const Vertex vertex = any_vertex(dice);
    Numbers question;
    put(vertex, question), put(scene, question);
    const Vector n = unit(vertex.normal), v = scene.eye - vertex.position;
    ShadingVariant other = variant;
    other.clamps_vertices = !variant.clamps_vertices;
    const Finding finding = compare(
        "shade_vertex(position " + words(vertex.position) + ", normal " + words(vertex.normal) +
            "), eye " + words(scene.eye) + "\n" + describe(scene),
        ask(e, ask_vertex, question), right_vertex(variant, vertex, scene),
        {{variant.clamps_vertices
              ? "Your variant cuts the colours of vertices to 0..1 before they are interpolated."
              : "Your variant does not cut the colours of vertices: only the picture does.",
          right_vertex(other, vertex, scene)},
         {"The normal is to have unit length.",
          right_light(variant, vertex.normal, unit(v), scene)},
         {"The direction to the viewer is to have unit length.", right_light(variant, n, v, scene)},
         {"The viewer is at `eye`: the direction leaves the vertex, eye - position.",
          right_light(variant, n, unit(scene.eye), scene)},
         {"The direction to the viewer points the other way.",
          right_light(variant, n, unit(-1 * v), scene)}});
    if (finding.share < 1) return finding;
  }
  return {};
}

Finding test_interpolate(Examination& e) {
  Dice dice(e.questions, "A4.3");
  for (int i = 0; i < 20; ++i) {
    const Vector corners[3] = {any_colour(dice, -2, 2), any_colour(dice, -2, 2),
                               any_colour(dice, -2, 2)};
    const Weights w = any_weights(dice);
    Numbers question;
    for (const Vector& corner : corners) put(corner, question);
    put(w, question);
    const Finding finding = compare("interpolate(" + words(corners[0]) + ", " + words(corners[1]) +
                                        ", " + words(corners[2]) + ")\n  with weights " +
                                        words({w.corner[0], w.corner[1], w.corner[2]}),
                                    ask(e, ask_interpolate, question), right_between(corners, w),
                                    {{"The weights belong to the corners in the same order.",
                                      right_between({corners[1], corners[2], corners[0]}, w)},
                                     {"The weights belong to the corners in the same order.",
                                      right_between({corners[2], corners[0], corners[1]}, w)}});
    if (finding.share < 1) return finding;
  }
  return {};
}

Finding test_normal(Examination& e) {
  const ShadingVariant variant = shading_variant(e.variant);
  Dice dice(e.questions, "A4.4");
  for (int i = 0; i < 40; ++i) {
    const Vector normals[3] = {any_vertex(dice).normal, any_vertex(dice).normal,
                               any_vertex(dice).normal};
    const Weights w = any_weights(dice);
    Numbers question;
    for (const Vector& normal : normals) put(normal, question);
    put(w, question);
    ShadingVariant other = variant;
    other.unit_first = !variant.unit_first;
    const Vector units[3] = {unit(normals[0]), unit(normals[1]), unit(normals[2])};
    const char* const not_unit =
        "What is between unit vectors is shorter: the result is to have "
        "unit length again.";
    const Finding finding =
        compare("interpolate_normal(" + words(normals[0]) + ", " + words(normals[1]) + ", " +
                    words(normals[2]) + ")\n  with weights " +
                    words({w.corner[0], w.corner[1], w.corner[2]}),
                ask(e, ask_normal, question), right_normal(variant, normals, w),
                {{not_unit, right_between(normals, w)},
                 {not_unit, right_between(units, w)},
                 {variant.unit_first ? "Your variant gives the vertices' normals unit length first."
                                     : "Your variant interpolates the normals as long as they are.",
                  right_normal(other, normals, w)}});
    if (finding.share < 1) return finding;
  }
  return {};
}

Finding test_fragment(Examination& e) {
  const ShadingVariant variant = shading_variant(e.variant);
  Dice dice(e.questions, "A4.5");
  for (int i = 0; i < 40; ++i) {
    const Scene scene = any_scene(dice);
    const Vertex triangle[3] = {any_vertex(dice), any_vertex(dice), any_vertex(dice)};
    const Weights w = any_weights(dice);
    Numbers question;
    for (const Vertex& vertex : triangle) put(vertex, question);
    put(w, question), put(scene, question);
    const auto& [a, b, c] = triangle;
    const Vector n = right_normal(variant, {a.normal, b.normal, c.normal}, w);
    const Vector centre = right_between({a.position, b.position, c.position}, w);
    const Vector views[3] = {unit(scene.eye - a.position), unit(scene.eye - b.position),
                             unit(scene.eye - c.position)};
    const Finding finding = compare(
        "shade_fragment() of a triangle whose corners lie at\n  " + words(a.position) + " " +
            words(b.position) + " " + words(c.position) + ", with normals\n  " + words(a.normal) +
            " " + words(b.normal) + " " + words(c.normal) + ", weights " +
            words({w.corner[0], w.corner[1], w.corner[2]}) + ", eye " + words(scene.eye) + "\n" +
            describe(scene),
        ask(e, ask_fragment, question), right_fragment(variant, triangle, w, scene),
        {{"That is Gouraud shading: the colours of the vertices, interpolated.",
          right_between({right_vertex(variant, a, scene), right_vertex(variant, b, scene),
                         right_vertex(variant, c, scene)},
                        w)},
         {"The direction to the viewer leaves the fragment's own position, interpolated.",
          right_light(variant, n, unit(scene.eye), scene)},
         {"The direction to the viewer leaves the fragment's own position, not a corner's.",
          right_light(variant, n, views[0], scene)},
         {"The direction to the viewer is to be worked out at the fragment, not interpolated.",
          right_light(variant, n, unit(right_between(views, w)), scene)},
         {"The direction to the viewer is to have unit length.",
          right_light(variant, n, scene.eye - centre, scene)}});
    if (finding.share < 1) return finding;
  }
  return {};
}

}  // namespace scanlit::assignments::shading
