#include "rasterizer/reflection_model.h"

#include <algorithm>

#include "rasterizer/fragment_span.h"
#include "rasterizer/radiance.h"

namespace scanlit {

namespace {

/// Arrays of vectors, as many as a span may have.
struct Arrays {
  float a[3][FragmentSpan::padded];

  void store(const Vec3<Batch>& v, std::size_t i) {
    v.x.store(a[0] + i), v.y.store(a[1] + i), v.z.store(a[2] + i);
  }
};

}  // namespace

std::size_t ReflectionModel::radiance(const ViewedSpan& in, std::span<const LightSource> lights,
                                      const RadianceSpan& out) const {
  Arrays to_light, to_viewer, diffuse, glossy;
  float share[FragmentSpan::padded];
  Batch sum[FragmentSpan::padded / Batch::lanes][6];
  for (auto& channels : sum) std::ranges::fill(channels, Batch(0));
  const std::size_t lanes = Batch::lanes;
  DirectionSpan directions{.size = in.size, .points = in.points, .parameters = in.parameters};
  for (int c = 0; c < 3; ++c) {
    directions.normal[c] = in.normal[c];
    directions.to_light[c] = to_light.a[c];
    directions.to_viewer[c] = in.to_viewer[0] ? in.to_viewer[c] : to_viewer.a[c];
    directions.tangent[c] = in.tangent[c];
  }
  for (std::size_t i = 0; i < in.size && !in.to_viewer[0]; i += lanes)
    to_viewer.store(broadcast(in.far_viewer), i);
  const ReflectionSpan reflection{.diffuse = {diffuse.a[0], diffuse.a[1], diffuse.a[2]},
                                  .glossy = {glossy.a[0], glossy.a[1], glossy.a[2]}};

  std::size_t evaluations = 0;
  for (const LightSource& light : lights) {
    bool dark = true;
    for (std::size_t i = 0; i < in.size; i += lanes) {
      const Vec3<Batch> n = load_vec3(in.normal, i);
      const Vec3<Batch> position = light.far ? Vec3<Batch>{} : load_vec3(in.position, i);
      const ArrivingLight arrives = arriving(light, position, n);
      to_light.store(arrives.to_light, i);
      arrives.share.store(share + i);
      dark &= none((dot(n, arrives.to_light) > Batch(0)) & (arrives.share > Batch(0)));
    }
    if (in.skip_dark && dark) continue;
    evaluate(directions, reflection);
    evaluations += in.size;
    for (std::size_t i = 0; i < in.size && out.evaluations; ++i) out.evaluations[i] += 1;
    for (std::size_t i = 0; i < in.size; i += lanes) {
      add_light(light, Batch::load(share + i),
                {load_rgb(reflection.diffuse, i), load_rgb(reflection.glossy, i)}, sum[i / lanes]);
    }
  }
  for (std::size_t i = 0; i < in.size; i += lanes) store(sum[i / lanes], out, i);
  return evaluations;
}

}  // namespace scanlit
