// (1) Vertex colours: from every format that has them to linear RGB, through all that happens to
// vertices on the way, into the picture.
#include <cmath>

#include "rasterizer/image/image_encoding.h"
#include "tests/unit/mesh_files.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using Colours = std::vector<glm::vec3>;

class MeshColours : public MeshFiles {};

void expect_colours(const Mesh& mesh, const Colours& expected) {
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  ASSERT_EQ(mesh.colours.size(), expected.size());
  for (std::size_t v = 0; v < expected.size(); ++v)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mesh.colours[v][c], expected[v][c], 1e-6) << v;
}

/// What codes of 8 bits stand for.
glm::vec3 codes(int r, int g, int b) {
  return {linear_from_srgb(r / 255.0), linear_from_srgb(g / 255.0), linear_from_srgb(b / 255.0)};
}

std::string ply_header(const std::string& format, const std::string& type) {
  std::string header = "ply\nformat " + format + " 1.0\nelement vertex 3\n";
  for (const char* name : {"x", "y", "z"}) header += std::string("property float ") + name + '\n';
  for (const char* name : {"red", "green", "blue", "alpha"})
    header += "property " + type + ' ' + name + '\n';
  return header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string off(const std::string& keyword, const std::string& vertices) {
  return keyword + "\n3 1 0\n" + vertices + "3 0 1 2\n";
}

TEST_F(MeshColours, BytesInPlyAreDecodedFromSrgb) {
  const std::string rows = "0 0 0 255 0 128 255\n1 0 0 1 2 3 0\n0 1 0 64 10 200 7\n3 0 1 2\n";
  const Colours expected = {codes(255, 0, 128), codes(1, 2, 3), codes(64, 10, 200)};
  const Mesh mesh = load("ascii.ply", ply_header("ascii", "uchar") + rows);
  expect_colours(mesh, expected);
  EXPECT_NEAR(mesh.colours[0].z, 0.2158605, 1e-6);  // code 128, by IEC 61966-2-1
  EXPECT_TRUE(mesh.warnings.empty());

  std::string binary = ply_header("binary_little_endian", "uchar");
  const unsigned char bytes[3][4] = {{255, 0, 128, 9}, {1, 2, 3, 9}, {64, 10, 200, 9}};
  const float points[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int v = 0; v < 3; ++v) {
    for (const float coordinate : points[v]) binary += bytes_of(coordinate);
    for (const unsigned char byte : bytes[v]) binary += bytes_of(byte);
  }
  binary += bytes_of(std::uint8_t(3)) + bytes_of(0) + bytes_of(1) + bytes_of(2);
  expect_colours(load("binary.ply", binary), expected);
}

TEST_F(MeshColours, ShortsInPlyAreDecodedFromSrgb) {
  const Mesh mesh = load("short.ply", ply_header("ascii", "ushort") +
                                          "0 0 0 65535 0 32896 0\n1 0 0 0 0 0 0\n"
                                          "0 1 0 257 0 0 0\n3 0 1 2\n");
  expect_colours(mesh, {codes(255, 0, 128), codes(0, 0, 0), codes(1, 0, 0)});
}

TEST_F(MeshColours, FractionsAreLinear) {
  const Colours expected = {{0.5f, 0.25f, 1}, {0, 0.003f, 1}, {1, 1, 0}};
  expect_colours(load("float.ply", ply_header("ascii", "float") +
                                       "0 0 0 .5 .25 1 1\n1 0 0 0 .003 1 1\n0 1 0 1 1 0 1\n"
                                       "3 0 1 2\n"),
                 expected);
  expect_colours(load("float.off", off("COFF",
                                       "0 0 0 .5 .25 1 1\n1 0 0 0 .003 1 1\n"
                                       "0 1 0 1 1 0 1\n")),
                 expected);
  expect_colours(load("float.obj", "v 0 0 0 .5 .25 1\nv 1 0 0 0 .003 1\nv 0 1 0 1 1 0\nf 1 2 3\n"),
                 expected);
}

TEST_F(MeshColours, WholeNumbersInOffAreCodes) {
  const Colours expected = {codes(255, 0, 128), codes(1, 1, 1), codes(0, 0, 1)};
  // With and without alpha; between normals and texture coordinates.
  expect_colours(load("rgba.off", off("COFF",
                                      "0 0 0 255 0 128 255\n1 0 0 1 1 1 255\n"
                                      "0 1 0 0 0 1 255\n")),
                 expected);
  expect_colours(load("rgb.off", off("COFF", "0 0 0 255 0 128\n1 0 0 1 1 1\n0 1 0 0 0 1\n")),
                 expected);
  const Mesh mesh = load("all.off", off("STCNOFF",
                                        "0 0 0 0 0 1 255 0 128 255 .1 .2\n"
                                        "1 0 0 0 0 1 1 1 1 255 .3 .4\n"
                                        "0 1 0 0 0 1 0 0 1 255 .5 .6\n"));
  expect_colours(mesh, expected);
  EXPECT_EQ(mesh.texcoords[2], glm::vec2(0.5f, 0.6f));
}

TEST_F(MeshColours, AreAbsentWhereTheFileHasNone) {
  EXPECT_TRUE(load("plain.obj", "v 0 0 0\nv 1 0 0 1\nv 0 1 0\nf 1 2 3\n").colours.empty());
  EXPECT_TRUE(load("plain.off", off("OFF", "0 0 0\n1 0 0\n0 1 0\n")).colours.empty());
  EXPECT_TRUE(
      load("plain.ply", ascii_ply("0 0 0\n1 0 0\n0 1 0\n", 3, "3 0 1 2\n", 1)).colours.empty());
}

TEST_F(MeshColours, FollowTheirVerticesThroughSplittingAndCopying) {
  // Each vertex of the tetrahedron has a colour of its own: whatever becomes of it, so has its
  // place.
  const Colours by_vertex = {{0.1f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.3f}, {0.4f, 0.4f, 0}};
  const auto expect_by_position = [&](const Mesh& mesh, std::size_t vertices) {
    EXPECT_EQ(mesh.positions.size(), vertices);
    ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
    for (std::size_t v = 0; v < vertices; ++v) {
      const glm::vec3& p = mesh.positions[v];
      EXPECT_EQ(mesh.colours[v], by_vertex[p.x > 0 ? 1 : p.y > 0 ? 2 : p.z > 0 ? 3 : 0]);
    }
  };
  const std::string vertices = "v 0 0 0 .1 0 0\nv 1 0 0 0 .2 0\nv 0 1 0 0 0 .3\nv 0 0 1 .4 .4 0\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  expect_by_position(load("smooth.obj", vertices + faces), 4);
  MeshOptions creased;
  creased.crease_deg = 30;
  expect_by_position(load("creased.obj", vertices + faces, creased), 12);
  // A third face at an edge, and a face that names a vertex twice: copies.
  const Mesh complex = load("complex.obj", vertices + faces + "f 1 2 3\nf 1 2 4 2\n");
  ASSERT_GE(complex.warnings.size(), 2u);
  expect_by_position(complex, complex.positions.size());
  EXPECT_GT(complex.positions.size(), 4u);
}

TEST_F(MeshColours, WhatIsOutOfRangeIsClampedAndSaid) {
  const Mesh mesh =
      load("wild.obj", "v 0 0 0 255 -1 .5\nv 1 0 0 nan 1 1\nv 0 1 0 .1 .2 .3\nf 1 2 3\n");
  expect_colours(mesh, {{1, 0, 0.5f}, {0, 1, 1}, {0.1f, 0.2f, 0.3f}});
  const auto said = [](int count) {
    return std::vector<std::string>{std::to_string(count) + " vertex colour" +
                                    (count == 1 ? "" : "s") +
                                    " not a number or out of range: clamped"};
  };
  EXPECT_EQ(mesh.warnings, said(2));
  const Mesh codes = load("wild.off", off("COFF", "0 0 0 300 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n"));
  EXPECT_EQ(codes.warnings, said(1));
}

TEST_F(MeshColours, VerticesWithoutOneAmongOthersAreWhite) {
  const Mesh mesh = load("some.obj", "v 0 0 0\nv 1 0 0 0 .5 0\nv 0 1 0\nf 1 2 3\n");
  expect_colours(mesh, {{1, 1, 1}, {0, 0.5f, 0}, {1, 1, 1}});
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_EQ(mesh.warnings[0], "2 vertices without a colour where others have one: drawn white");
}

TEST_F(MeshColours, MalformedOnesAreErrors) {
  EXPECT_EQ(error_of("word.obj", "v 0 0 0 red 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
            "word.obj:1: colour 'red' is not a number");
  EXPECT_EQ(error_of("word.off", off("COFF", "0 0 0 1 x 1\n1 0 0 0 0 0\n0 1 0 0 0 0\n")),
            "word.off:3: colour 'x' is not a number");
  EXPECT_EQ(error_of("few.off", off("COFF", "0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 0\n")),
            "few.off:3: a vertex has 6 numbers");
  EXPECT_EQ(error_of("word.ply", ply_header("ascii", "uchar") + "0 0 0 .5 0 0 0\n"
                                                                "1 0 0 0 0 0 0\n0 1 0 0 0 0 0\n"
                                                                "3 0 1 2\n"),
            "word.ply:14: value '.5' is not a whole number");
}

/// Reflects the vertex colour.
struct ShowColour {
  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const SurfacePoint<T>& p) const {
    return {.diffuse = p.vertex_colour, .glossy = Rgb<T>(T(0))};
  }
};

TEST_F(MeshColours, ReachThePicture) {
  // A triangle that is clipped at the near plane on its way: one corner is behind the eye.
  using namespace test;
  const auto mesh = std::make_shared<Mesh>(
      load("clipped.obj", "v -30 -1 -10 1 0 0\nv 30 -1 -10 0 1 0\nv 0 -1 10 0 0 1\nf 3 2 1\n"));
  Scene scene = scene_of({object_of(mesh, ShowColour())});
  scene.lights[0].direction = {0, 1, 0};
  const Picture picture = picture_of(scene, eye_at_origin(), 64, 64);
  ASSERT_EQ(picture.stats.clipped, 1);
  int compared = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (picture.triangle(x, y) == no_id) continue;
      // The point of the plane y = -1 that the pixel sees: z = -10 (1 - 2 b), b the third weight.
      const double down = (2 * (y + 0.5) / 64 - 1), distance = 1 / down;
      const double third = (10 - distance) / 20, along = (2 * (x + 0.5) / 64 - 1) * distance;
      const double second = ((1 - third) + along / 30) / 2;
      EXPECT_NEAR(picture.colour(x, y)[0], 1 - second - third, 2e-3);
      EXPECT_NEAR(picture.colour(x, y)[1], second, 2e-3);
      EXPECT_NEAR(picture.colour(x, y)[2], third, 2e-3);
      ++compared;
    }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace scanlit
