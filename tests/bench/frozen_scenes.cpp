#include "frozen_scenes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "models/registry.h"
#include "rasterizer/shapes.h"

namespace scanlit::bench {

namespace {

/// The same numbers with every standard library, which its distributions do not promise.
class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}

  double between(double from, double to) { return from + (to - from) * random_() * 0x1p-32; }
  int whole(int from, int to) { return std::min(to, int(between(from, to + 1))); }
  glm::dvec3 direction() {
    const double z = between(-1, 1), phi = between(0, 6.283185307), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  template <class T, std::size_t n>
  const T& one_of(const T (&all)[n]) {
    return all[whole(0, int(n) - 1)];
  }

 private:
  std::mt19937 random_;
};

std::shared_ptr<const ReflectionModel> model(Chance& chance) {
  const char* const specifications[] = {
      "lambert:kd=.7/.4/.3",
      "phong:kd=.3/.4/.6,ks=.4,n=80",
      "blinn-phong:kd=.6/.5/.2,ks=.3,n=20",
      "blinn-phong:kd=.2/.5/.3,ks=.5,n=300,normalised=1",
      "oren-nayar:rho=.7/.6/.5,sigma=.4",
      "oren-nayar-full:rho=.8/.7/.6,sigma=.5",
      "cook-torrance:m=.4,F=gold",
      "cook-torrance:D=ggx,a=.3,G=smith-correlated,F=dielectric,kd=.5",
      "torrance-sparrow:kd=.4/.2/.2,ks=.5,m=.3",
      "ashikhmin-shirley",
      "material:copper",
      "sum:.6*(lambert:kd=.8/.3/.2),.4*(phong:n=30)"};
  return models::make(chance.one_of(specifications)).model;
}

Object object(Chance& chance) {
  const char* const shapes[] = {"sphere:16",  "sphere:40",   "sphere:150", "torus:24",
                                "torus:80",   "teapot:8",    "teapot:24",  "cube",
                                "trefoil:20", "icosphere:3", "cone:40",    "cylinder:60"};
  Object result;
  result.mesh = std::make_shared<Mesh>(make_shape(chance.one_of(shapes)));
  const glm::vec3 place(1.2 * chance.direction()), axis(chance.direction());
  const float size = float(chance.between(.4, 1.2)), turn = float(chance.between(0, 6));
  result.world_from_object =
      glm::scale(glm::rotate(glm::translate(glm::mat4(1), place), turn, axis), glm::vec3(size));
  result.material.model = model(chance);
  result.material.ka = Rgb<double>(chance.between(0, .1));
  return result;
}

Light light(Chance& chance, int of) {
  const LightKind kinds[] = {LightKind::directional, LightKind::point, LightKind::spot};
  Light result;
  result.kind = chance.one_of(kinds);
  result.colour = {chance.between(.3, 1), chance.between(.3, 1), chance.between(.3, 1)};
  result.direction = chance.direction();
  result.position = chance.between(2, 5) * chance.direction();
  result.intensity = chance.between(.5, 1.5) / std::sqrt(double(of));
  if (result.kind != LightKind::directional) {
    result.constant = 0, result.quadratic = 1;
    result.intensity *= 10;
  }
  if (result.kind == LightKind::spot) {
    result.direction = -result.position;
    result.inner_deg = 15, result.outer_deg = 35;
  }
  return result;
}

}  // namespace

std::vector<FrozenScene> frozen_scenes() {
  std::vector<FrozenScene> all;
  for (unsigned seed = 0; seed < 10; ++seed) {
    Chance chance(seed);
    FrozenScene frozen{.name = "R" + std::to_string(seed), .scene = {}, .camera = {}};
    for (int i = chance.whole(1, 5); i > 0; --i) frozen.scene.objects.push_back(object(chance));
    const int lights = int(std::exp2(chance.between(0, 6.5)));
    for (int i = 0; i < std::min(lights, 64); ++i)
      frozen.scene.lights.push_back(light(chance, lights));
    frozen.camera.eye = chance.between(3, 6) * chance.direction();
    frozen.camera.target = .5 * chance.direction();
    frozen.camera.fov_deg = chance.between(25, 60);
    all.push_back(std::move(frozen));
  }
  return all;
}

}  // namespace scanlit::bench
