#include "osmesa_peer.h"

#define GL_GLEXT_PROTOTYPES  // of what came after OpenGL 1.1
#include <GL/osmesa.h>

#include <algorithm>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "osmesa_shaders.h"
#include "rasterizer/error.h"

namespace scanlit::bench {

namespace {

constexpr std::size_t row_bytes = 4 * std::size_t(picture_width);

unsigned compile(GLenum kind, const std::string& text) {
  const unsigned shader = glCreateShader(kind);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  int compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  char log[1000] = {};
  if (!compiled) glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  if (!compiled) throw Error(std::string("llvmpipe refuses a shader: ") + log);
  return shader;
}

unsigned link(const ShaderTexts& texts) {
  const unsigned program = glCreateProgram();
  for (const unsigned shader :
       {compile(GL_VERTEX_SHADER, texts.vertex), compile(GL_FRAGMENT_SHADER, texts.fragment)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glBindAttribLocation(program, 0, "object_position");
  glBindAttribLocation(program, 1, "object_normal");
  glLinkProgram(program);
  int linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) throw Error("llvmpipe cannot link the shaders");
  return program;
}

void set_lights(unsigned program) {
  std::vector<glm::vec3> positions, colours;
  for (const PointLight& light : point_lights()) {
    positions.emplace_back(light.position);
    colours.emplace_back(light.colour);
  }
  const auto set = [&](const char* name, const std::vector<glm::vec3>& values) {
    glUniform3fv(glGetUniformLocation(program, name), int(values.size()),
                 glm::value_ptr(values.front()));
  };
  set("light_position", positions);
  set("light_colour", colours);
}

void set(unsigned program, const char* name, const glm::vec3& value) {
  glUniform3fv(glGetUniformLocation(program, name), 1, glm::value_ptr(value));
}

}  // namespace

OsmesaPeer::OsmesaPeer() {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  context_ = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!context_ || !OSMesaMakeCurrent(context_, picture_.data(), GL_UNSIGNED_BYTE, picture_width,
                                      picture_height))
    throw Error("OSMesa gives no OpenGL 3.3 context");
  OSMesaPixelStore(OSMESA_Y_UP, 0);  // row 0 on top
  make_framebuffer_object();
  glViewport(0, 0, picture_width, picture_height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDisable(GL_DITHER);
  glClearColor(0, 0, 0, 0);
}

OsmesaPeer::~OsmesaPeer() {
  if (context_) OSMesaDestroyContext(context_);
}

void OsmesaPeer::make_framebuffer_object() {
  unsigned renderbuffers[2];
  glGenFramebuffers(1, &framebuffer_object_);
  glGenRenderbuffers(2, renderbuffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_object_);
  const auto attach = [](unsigned renderbuffer, GLenum format, GLenum attachment) {
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, picture_width, picture_height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
  };
  attach(renderbuffers[0], GL_RGBA8, GL_COLOR_ATTACHMENT0);
  attach(renderbuffers[1], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error("llvmpipe gives no framebuffer of 8-bit RGBA with 24 bits of depth");
}

OsmesaPeer::Uploaded OsmesaPeer::upload(const Mesh& mesh) const {
  Uploaded uploaded{.vertex_array = 0, .buffers = {}, .index_count = int(mesh.indices.size())};
  glGenVertexArrays(1, &uploaded.vertex_array);
  glBindVertexArray(uploaded.vertex_array);
  glGenBuffers(2, uploaded.buffers);
  std::vector<glm::vec3> interleaved;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    interleaved.push_back(mesh.positions[i]);
    interleaved.push_back(mesh.normals[i]);
  }
  const auto stride = GLsizei(2 * sizeof(glm::vec3));
  glBindBuffer(GL_ARRAY_BUFFER, uploaded.buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(interleaved.size() * sizeof(glm::vec3)),
               interleaved.data(), GL_STATIC_DRAW);
  for (const unsigned attribute : {0u, 1u}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(attribute * sizeof(glm::vec3)));
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded.buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(std::uint32_t)),
               mesh.indices.data(), GL_STATIC_DRAW);
  return uploaded;
}

void OsmesaPeer::drop_meshes() {
  for (const Uploaded& mesh : meshes_) {
    glDeleteVertexArrays(1, &mesh.vertex_array);
    glDeleteBuffers(2, mesh.buffers);
  }
  meshes_.clear();
  mesh_of_draw_.clear();
}

void OsmesaPeer::prepare(const BenchScene& scene) {
  drop_meshes();
  std::map<const Mesh*, std::size_t> index;
  for (const Placement& placement : scene.placements) {
    const auto [entry, is_new] = index.try_emplace(placement.mesh.get(), meshes_.size());
    if (is_new) meshes_.push_back(upload(*placement.mesh));
    mesh_of_draw_.push_back(entry->second);
  }
  glDeleteProgram(program_);
  program_ = link(shader_texts(scene.shader));
  glUseProgram(program_);
  set(program_, "eye", scene.eye);
  if (scene.shader == Shader::point_lights) set_lights(program_);
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw Error("OpenGL error " + std::to_string(error));
}

void OsmesaPeer::draw_all(const BenchScene& scene, int frame) const {
  const double aspect = double(picture_width) / picture_height;
  const glm::dmat4 clip_from_world =
      glm::perspective(glm::radians(fov_deg), aspect, near_distance, far_distance) *
      glm::lookAt(scene.eye, scene.eye + viewing_direction(scene, frame), glm::dvec3(0, 1, 0));
  const int clip = glGetUniformLocation(program_, "clip_from_object");
  const int world = glGetUniformLocation(program_, "world_from_object");
  const int normal = glGetUniformLocation(program_, "normal_from_object");
  const int base = glGetUniformLocation(program_, "base");
  set(program_, "to_light", to_light(scene, frame));
  for (std::size_t i = 0; i < scene.placements.size(); ++i) {
    const Placement& placement = scene.placements[i];
    const glm::mat4 m = world_from_object(scene, placement, frame);
    const glm::mat4 clip_from_object(clip_from_world * glm::dmat4(m));
    const glm::mat3 normal_from_object(glm::inverse(glm::transpose(glm::dmat3(glm::mat3(m)))));
    const glm::vec3 colour(placement.base);
    glUniformMatrix4fv(clip, 1, GL_FALSE, glm::value_ptr(clip_from_object));
    glUniformMatrix4fv(world, 1, GL_FALSE, glm::value_ptr(m));
    glUniformMatrix3fv(normal, 1, GL_FALSE, glm::value_ptr(normal_from_object));
    glUniform3fv(base, 1, glm::value_ptr(colour));
    const Uploaded& mesh = meshes_[mesh_of_draw_[i]];
    glBindVertexArray(mesh.vertex_array);
    glDrawElements(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr);
  }
}

void OsmesaPeer::draw(const BenchScene& scene, int frame, Target target) {
  const bool direct = target == Target::buffer;
  glBindFramebuffer(GL_FRAMEBUFFER, direct ? 0 : framebuffer_object_);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_all(scene, frame);
  if (direct)
    glFinish();
  else
    glReadPixels(0, 0, picture_width, picture_height, GL_RGBA, GL_UNSIGNED_BYTE, picture_.data());
}

Picture OsmesaPeer::upside_down() const {
  Picture turned(picture_.size());
  for (std::size_t y = 0; y < std::size_t(picture_height); ++y)
    std::copy_n(&picture_[y * row_bytes], row_bytes,
                &turned[(std::size_t(picture_height) - 1 - y) * row_bytes]);
  return turned;
}

std::string OsmesaPeer::version() {
  const auto text = [](GLenum name) {
    return std::string(reinterpret_cast<const char*>(glGetString(name)));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace scanlit::bench
