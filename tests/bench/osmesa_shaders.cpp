#include "osmesa_shaders.h"

namespace scanlit::bench {

namespace {

const std::string version = "#version 330 core\n";

const std::string transforms = R"(
in vec3 object_position, object_normal;
uniform mat4 clip_from_object, world_from_object;
uniform mat3 normal_from_object;
)";

// Each of the following defines radiance(position, interpolated normal), in world space.
const std::string blinn_phong = R"(
uniform vec3 eye, base, to_light;
vec3 radiance(vec3 p, vec3 normal) {
  vec3 l = to_light, n = normalize(normal), v = normalize(eye - p), h = normalize(l + v);
  float n_l = dot(n, l);
  float glossy = n_l > 0.0 ? .3 * pow(max(dot(n, h), 0.0), 32.0) : 0.0;
  return .05 * base + base * max(n_l, 0.0) + glossy;
}
)";

// F is |r_s|^2 t / (t + u), the mean of both polarisations with a single division.
const std::string cook_torrance = R"(
uniform vec3 eye, to_light;
const float pi = 3.14159265359;
vec3 conductor(float c) {
  const vec3 eta = vec3(.143, .375, 1.442), k = vec3(3.983, 2.386, 1.603);
  float c2 = c * c, s2 = 1.0 - c2;
  vec3 d = eta * eta - k * k - s2;
  vec3 a2b2 = sqrt(d * d + 4.0 * eta * eta * k * k);
  vec3 a2c = 2.0 * c * sqrt(.5 * (a2b2 + d));
  vec3 r_s = (a2b2 + c2 - a2c) / (a2b2 + c2 + a2c);
  vec3 t = c2 * a2b2 + s2 * s2;
  return r_s * t / (t + a2c * s2);
}
vec3 radiance(vec3 p, vec3 normal) {
  const vec3 kd = vec3(.3, .2, .05);
  const float m = .3;
  vec3 l = to_light, n = normalize(normal), v = normalize(eye - p), h = normalize(l + v);
  float n_l = dot(n, l), n_v = max(dot(n, v), 1e-4);
  float n_h = max(dot(n, h), 1e-4), v_h = max(dot(v, h), 1e-4);
  float c2 = n_h * n_h, m2 = m * m;
  float d = exp((c2 - 1.0) / (c2 * m2)) / (pi * m2 * c2 * c2);
  float g = min(1.0, 2.0 * n_h * min(n_v, n_l) / v_h);
  // (n.l) / (4 (n.l)(n.v)): n.l cancels.
  return n_l > 0.0 ? n_l * kd / pi + conductor(v_h) * (d * g / (4.0 * n_v)) : vec3(0.0);
}
)";

const std::string point_lights_text = R"(
uniform vec3 eye, base, light_position[16], light_colour[16];
vec3 radiance(vec3 p, vec3 normal) {
  vec3 n = normalize(normal), v = normalize(eye - p), sum = .05 * base;
  for (int k = 0; k < 16; ++k) {
    vec3 offset = light_position[k] - p;
    float d2 = dot(offset, offset);
    vec3 l = offset * inversesqrt(d2), h = normalize(l + v);
    float n_l = dot(n, l);
    float glossy = n_l > 0.0 ? .3 * pow(max(dot(n, h), 0.0), 32.0) : 0.0;
    sum += light_colour[k] / d2 * (base * max(n_l, 0.0) + glossy);
  }
  return sum;
}
)";

}  // namespace

ShaderTexts shader_texts(Shader shader) {
  if (shader == Shader::gouraud)
    return {.vertex = version + transforms + blinn_phong + R"(
out vec3 vertex_colour;
void main() {
  gl_Position = clip_from_object * vec4(object_position, 1);
  vec3 p = (world_from_object * vec4(object_position, 1)).xyz;
  vertex_colour = clamp(radiance(p, normal_from_object * object_normal), 0.0, 1.0);
})",
            .fragment = version + R"(
in vec3 vertex_colour;
out vec4 colour;
void main() { colour = vec4(vertex_colour, 1); })"};

  const std::string& radiance = shader == Shader::cook_torrance  ? cook_torrance
                                : shader == Shader::point_lights ? point_lights_text
                                                                 : blinn_phong;
  return {.vertex = version + transforms + R"(
out vec3 position, normal;
void main() {
  gl_Position = clip_from_object * vec4(object_position, 1);
  position = (world_from_object * vec4(object_position, 1)).xyz;
  normal = normal_from_object * object_normal;
})",
          .fragment = version + radiance + R"(
in vec3 position, normal;
out vec4 colour;
void main() { colour = vec4(radiance(position, normal), 1); })"};
}

}  // namespace scanlit::bench
