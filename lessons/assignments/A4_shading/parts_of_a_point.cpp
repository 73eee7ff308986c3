// A4.1: the light at a point.
#include <algorithm>
#include <cmath>
#include <functional>

#include "lessons/assignments/A4_shading/parts.h"

namespace scanlit::assignments::shading {

namespace {

/// What the terms of light() give when one of them is done in another way.
struct Terms {
  double wrap;
  bool mirrored;
  bool diffuse_cut = true, highlight_cut = true, highlight_behind = false, ambient = true;

  Colour operator()(Vector normal, Vector v, const Scene& scene) const {
    Colour sum = ambient ? scene.ambient : Colour{0, 0, 0};
    for (const Light& light : scene.lights) {
      const Vector l = light.to_light;
      const double n_l = dot(normal, l);
      double diffuse = (n_l + wrap) / (1 + wrap);
      if (diffuse_cut) diffuse = std::max(0.0, diffuse);
      double cosine = mirrored ? dot(2 * n_l * normal - l, v) : dot(normal, unit(l + v));
      if (highlight_cut) cosine = std::max(0.0, cosine);
      const double highlight =
          n_l > 0 || highlight_behind ? scene.ks * std::pow(cosine, scene.n) : 0;
      sum = sum + light.colour * (diffuse * scene.kd + highlight * Vector{1, 1, 1});
    }
    return sum;
  }
};

std::vector<Mistake> mistakes_of_light(const ShadingVariant& v, Vector normal, Vector to_viewer,
                                       const Scene& scene) {
  const auto by = [&](const char* hint, const std::function<void(Terms&)>& change) {
    Terms terms{v.wrap, v.mirrored_light};
    change(terms);
    return Mistake{hint, terms(normal, to_viewer, scene)};
  };
  return {
      by("That is Lambert's N.L: your variant wraps it, max(0, (N.L + w) / (1 + w)).",
         [](Terms& t) { t.wrap = 0; }),
      by("The diffuse term is negative for a light behind the surface: cut it at 0.",
         [](Terms& t) { t.diffuse_cut = false; }),
      by("The highlight is there although the light is behind the surface (N.L <= 0).",
         [](Terms& t) { t.highlight_behind = true; }),
      by("The highlight's cosine is negative: cut it at 0 before it is raised to a power.",
         [](Terms& t) { t.highlight_cut = false; }),
      by(v.mirrored_light ? "That is (N.H)^n: your variant's highlight is (R.V)^n."
                          : "That is (R.V)^n: your variant's highlight is (N.H)^n.",
         [](Terms& t) { t.mirrored = !t.mirrored; }),
      by("The ambient term is missing.", [](Terms& t) { t.ambient = false; }),
  };
}

}  // namespace

Finding test_light(Examination& e) {
  const ShadingVariant variant = shading_variant(e.variant);
  Dice dice(e.questions, "A4.1");
  for (int i = 0; i < 80; ++i) {
    const Scene scene = any_scene(dice);
    const Vector normal = any_direction(dice);
    const Vector to_viewer = unit(any_direction(dice) + normal);
    Numbers question;
    put(normal, question), put(to_viewer, question), put(scene, question);
    const Finding finding =
        compare("light(N " + words(normal) + ", V " + words(to_viewer) + ")\n" + describe(scene),
                ask(e, ask_light, question), right_light(variant, normal, to_viewer, scene),
                mistakes_of_light(variant, normal, to_viewer, scene));
    if (finding.share < 1) return finding;
  }
  return {};
}

}  // namespace scanlit::assignments::shading
