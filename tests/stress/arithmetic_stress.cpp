// Inf, NaN, subnormal, huge and tiny values wherever a number goes in: a clear error, or a picture
// without a NaN in it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "rasterizer/error.h"
#include "tests/stress/random_scene.h"

namespace scanlit::stress {
namespace {

/// A number of a scene: its name, and how to set it.
struct Field {
  std::string name;
  std::function<void(double)> set;
};

template <class V>
void add_components(std::vector<Field>& fields, const std::string& name, V& v, int count) {
  for (int i = 0; i < count; ++i)
    fields.push_back({name, [&v, i](double x) {
                        using T = std::decay_t<decltype(v[0])>;
                        v[i] = T(x);
                      }});
}
void add_colour(std::vector<Field>& fields, const std::string& name, Rgb<double>& c) {
  for (double* channel : {&c.r, &c.g, &c.b})
    fields.push_back({name, [channel](double x) { *channel = x; }});
}
void add_numbers(std::vector<Field>& fields, const std::string& name,
                 std::initializer_list<double*> numbers) {
  for (double* number : numbers) fields.push_back({name, [number](double x) { *number = x; }});
}

/// Any element of an attribute.
template <class V>
void add_attribute(std::vector<Field>& fields, const std::string& name, std::vector<V>& values,
                   Property& property) {
  const auto at = std::size_t(property.whole(0, int(values.size()) - 1));
  add_components(fields, "mesh " + name, values[at], int(V::length()));
}

std::vector<Field> fields_of(RandomScene& all, Property& property) {
  std::vector<Field> fields;
  add_components(fields, "camera eye", all.camera.eye, 3);
  add_components(fields, "camera target", all.camera.target, 3);
  add_components(fields, "camera up", all.camera.up, 3);
  add_numbers(fields, "camera number",
              {&all.camera.fov_deg, &all.camera.height, &all.camera.near, &all.camera.far});
  add_colour(fields, "ambient", all.scene.ambient);
  add_colour(fields, "background", all.scene.background);
  for (Light& light : all.scene.lights) {
    add_components(fields, "light direction", light.direction, 3);
    add_components(fields, "light position", light.position, 3);
    add_colour(fields, "light colour", light.colour);
    add_numbers(fields, "light number",
                {&light.intensity, &light.constant, &light.linear, &light.quadratic,
                 &light.inner_deg, &light.outer_deg});
  }
  for (Object& object : all.scene.objects) {
    add_colour(fields, "ka", object.material.ka);
    add_colour(fields, "object colour", object.material.object_colour);
    add_numbers(fields, "ambient share", {&object.material.ambient_share});
    add_components(fields, "tangents axis", object.material.tangents.axis, 3);
    add_components(fields, "tangents centre", object.material.tangents.centre, 3);
    for (int column = 0; column < 4; ++column)
      add_components(fields, "transform", object.world_from_object[column], 4);
    Mesh& mesh = *std::const_pointer_cast<Mesh>(object.mesh);
    add_attribute(fields, "position", mesh.positions, property);
    add_attribute(fields, "normal", mesh.normals, property);
    add_attribute(fields, "texcoord", mesh.texcoords, property);
    add_attribute(fields, "tangent", mesh.tangents, property);
    add_attribute(fields, "colour", mesh.colours, property);
  }
  return fields;
}

double awkward(Property& property) {
  using Limits = std::numeric_limits<double>;
  const double sign = property.any_of(-1.0, 1.0);
  switch (property.whole(0, 7)) {
    case 0: return Limits::quiet_NaN();
    case 1: return sign * Limits::infinity();
    case 2: return 0 * sign;
    case 3: return sign * property.decades(-323, -38);  // subnormal or zero as float
    case 4: return sign * property.decades(-38, -10);
    case 5: return sign * property.decades(10, 38);
    case 6: return sign * double(std::numeric_limits<float>::max());
    default: return sign * property.decades(38, 308);  // infinite as float
  }
}

/// The colour alone, off by up to so many codes.
Framebuffer draw_within(double tolerance, RandomScene all) {
  Framebuffer framebuffer(all.width, all.height);
  all.settings.tolerance = tolerance;
  render(all.scene, all.camera, all.settings, framebuffer);
  return framebuffer;
}

bool all_finite(const Framebuffer& f) {
  for (const auto* plane : {&f.colour, &f.depth, &f.normal, &f.ambient, &f.diffuse, &f.glossy})
    if (!std::ranges::all_of(*plane, [](float v) { return std::isfinite(v); })) return false;
  return true;
}

TEST(Arithmetic, AwkwardNumbersInEveryField) {
  Property property{
      "an awkward number is refused by one clear line, or the picture is finite, "
      "also with tolerance 1",
      "1 to 3 numbers of a random scene (camera, lights, materials, transforms, mesh "
      "attributes) replaced by NaN, Inf, 0, subnormal, 1e-38 to 1e-10, 1e10 to 1e308",
      "pictures that are not finite", 2000};
  std::int64_t drawn = 0, refused = 0;
  while (property.next()) {
    RandomScene all = random_scene(property);
    all.width = std::min(all.width, 40), all.height = std::min(all.height, 30);
    const std::vector<Field> fields = fields_of(all, property);
    std::string what;
    for (int i = property.whole(1, 3); i > 0; --i) {
      const Field& field = fields[std::size_t(property.whole(0, int(fields.size()) - 1))];
      const double value = awkward(property);
      field.set(value);
      what += (what.empty() ? "" : ", ") + field.name + " " + std::to_string(value);
    }
    SCOPED_TRACE(what);
    try {
      const bool fine = all_finite(draw(all)) && all_finite(draw_within(1, all));
      EXPECT_TRUE(fine);
      property.measure(!fine, what);
      ++drawn;
    } catch (const Error& error) {
      const std::string line = error.what();
      EXPECT_TRUE(line.size() > 10 && line.find('\n') == line.npos) << line;
      ++refused;
    }
  }
  property.expect_more_than(500, std::min(drawn, refused));
}

}  // namespace
}  // namespace scanlit::stress
