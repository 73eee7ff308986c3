#include "rasterizer/mesh.h"

#include <glm/geometric.hpp>
#include <set>
#include <tuple>

#include "tests/unit/mesh_files.h"

namespace scanlit {
namespace {

using MeshTest = MeshFiles;

const std::string tetrahedron_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

std::string binary_stl_tetrahedron() {
  const glm::vec3 point[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  // "solid" in front of binary data, as some programs write it
  std::string bytes = "solid" + std::string(75, ' ') + bytes_of(std::uint32_t(4));
  for (const auto& face : {std::tuple(0, 2, 1), {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    const auto [a, b, c] = face;
    bytes += bytes_of(glm::vec3(0)) + bytes_of(point[a]) + bytes_of(point[b]) + bytes_of(point[c]) +
             bytes_of(std::uint16_t(0));
  }
  return bytes;
}

std::string ascii_stl_tetrahedron() {
  const std::string point[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  std::string text = "solid outer space\n";  // "outer" in the name is not a facet
  for (const auto& face : {std::tuple(0, 2, 1), {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    const auto [a, b, c] = face;
    text += "facet normal 0 0 0\n outer loop\n  vertex " + point[a] + "\n  vertex " + point[b] +
            "\n  vertex " + point[c] + "\n endloop\nendfacet\n";
  }
  return text + "endsolid outer space\n";
}

std::string big_endian(std::string bytes) { return {bytes.rbegin(), bytes.rend()}; }

// With double coordinates, elements and properties that are not drawn, and lists of long counts.
std::string binary_ply_tetrahedron(bool big) {
  const auto put = [&](auto value) { return big ? big_endian(bytes_of(value)) : bytes_of(value); };
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\ncomment made by a test\nelement vertex 4\n"
                      "property double x\nproperty double y\nproperty double z\n"
                      "property uchar red\nelement edge 1\nproperty short length\n"
                      "element face 4\nproperty list uint float quality\n"
                      "property list int ushort vertex_index\nend_header\n";
  for (const auto& p : {glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
    bytes += put(p.x) + put(p.y) + put(p.z) + put(std::uint8_t(255));
  bytes += put(std::int16_t(-1));
  for (const auto& face : {std::tuple(0, 2, 1), {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    const auto [a, b, c] = face;
    bytes += put(std::uint32_t(1)) + put(0.5f) + put(std::int32_t(3)) + put(std::uint16_t(a)) +
             put(std::uint16_t(b)) + put(std::uint16_t(c));
  }
  return bytes;
}

// Version 1.2: faces are lists of vertices. Chunk headers: vertex positions, face topology, end.
std::string om_tetrahedron() {
  std::string bytes = "OMT" + bytes_of(std::uint8_t(1 << 5 | 2)) + bytes_of(std::uint32_t(4)) +
                      bytes_of(std::uint32_t(4)) + bytes_of(std::uint32_t(6));
  bytes += bytes_of(std::uint16_t(0x1600));
  for (const auto& p : {glm::vec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) bytes += bytes_of(p);
  bytes += bytes_of(std::uint16_t(2 << 2 | 7 << 5));
  for (const int i : {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}) bytes += bytes_of(std::int8_t(i));
  return bytes + bytes_of(std::uint16_t(0x1c));
}

void expect_tetrahedron(const Mesh& mesh) {
  EXPECT_EQ(mesh.triangle_count(), 4u);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_TRUE(mesh.closed);
  EXPECT_TRUE(mesh.warnings.empty());
  EXPECT_TRUE(mesh.texcoords.empty());
  std::set<std::tuple<float, float, float>> corners;
  for (const glm::vec3& p : mesh.positions) corners.emplace(p.x, p.y, p.z);
  EXPECT_EQ(corners, (decltype(corners){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-6);
    EXPECT_GT(glm::dot(mesh.normals[i], mesh.positions[i] - glm::vec3(0.25f)), 0);
  }
}

TEST_F(MeshTest, ReadsEveryFormat) {
  for (const auto& [name, bytes] : std::vector<std::pair<std::string, std::string>>{
           {"t.obj", tetrahedron_obj},
           {"t.OFF", "OFF\n4 4 6\n" + tetrahedron_points + tetrahedron_faces},
           {"t.ply", ascii_ply(tetrahedron_points, 4, tetrahedron_faces, 4)},
           {"little.ply", binary_ply_tetrahedron(false)},
           {"big.ply", binary_ply_tetrahedron(true)},
           {"text.stl", ascii_stl_tetrahedron()},
           {"binary.stl", binary_stl_tetrahedron()},
           {"t.om", om_tetrahedron()}}) {
    SCOPED_TRACE(name);
    expect_tetrahedron(load(name, bytes));
  }
}

TEST_F(MeshTest, ReadsFilesAfterEachOtherWhateverTheOneBeforeHeld) {
  const std::string with_normals =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list "
      "uchar int vertex_indices\nend_header\n0 0 0 0 1 0\n1 0 0 0 1 0\n0 1 0 0 1 0\n3 0 1 2\n";
  EXPECT_EQ(load("n.ply", with_normals).normals[0], glm::vec3(0, 1, 0));
  expect_tetrahedron(load("t.ply", ascii_ply(tetrahedron_points, 4, tetrahedron_faces, 4)));
  EXPECT_EQ(load("n.ply", with_normals).normals[0], glm::vec3(0, 1, 0));
}

TEST_F(MeshTest, ReadsObjAsPeopleWriteIt) {
  expect_tetrahedron(load("relative.obj",
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf 1 2 -1\nf 2 3 -1\n"
                          "f -4 -1 -2\n"));
  expect_tetrahedron(load("forward.obj",
                          "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                          "v 0 0 1\n"));
  std::string mac = tetrahedron_obj, windows;
  for (char& c : mac) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    if (c == '\n') c = '\r';
  }
  expect_tetrahedron(load("mac.obj", mac));
  expect_tetrahedron(load("windows.obj", "\xef\xbb\xbf" + windows));
  expect_tetrahedron(load("odd.obj",
                          "mtllib /dev/zero\no a#b\nusemtl none\nv +0 0. -0 1\nv 1e0 .0 0 .5\n"
                          "v 0 1.0E+00 0\nv 0 1e-400 1\nl 1 2\np 1\nf 1 3 \\\n 2 # three\n"
                          "f 1/ 2// 4\nf 2 3 4\nf 1 4 3"));
}

TEST_F(MeshTest, ReadsOffWithCommentsColoursAndVertexNormals) {
  const Mesh mesh = load("t.off",
                         "STCNOFF # all of it\n\n3 1 0\n0 0 0 0 1 0 255 0 0 .25 .75\n"
                         "1 0 0  0 2 0  0 255 0  1 0\n# between\n0 1 0 0 1 0 0 0 255 0 1\n"
                         "3 0 1 2 255 255 0\n");
  ASSERT_EQ(mesh.positions.size(), 3u);
  for (const glm::vec3& n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.texcoords[0], glm::vec2(.25f, .75f));
}

TEST_F(MeshTest, CopiedVerticesKeepTheirNormals) {
  // Three faces at the edge 0-1: two of them get vertices of their own.
  const Mesh mesh = load("t.off",
                         "NOFF\n5 3 0\n0 0 0 0 1 0\n0 0 1 0 1 0\n1 0 0 0 1 0\n0 1 0 0 1 0\n"
                         "-1 0 0 0 1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
  EXPECT_EQ(mesh.warnings.size(), 1u);
  for (const glm::vec3& n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 1, 0));
}

TEST_F(MeshTest, KeepsObjNormalsAndTexcoordsPerCorner) {
  const Mesh mesh = load("t.obj",
                         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt .5\nvn 0 0 5\n"
                         "vn 0 1 0\nf 1/1/1 2/2/1 3/3/1\nf 1/1/2 3/2/1 4/3/1\n");
  // Vertex 1 has two normals, vertex 3 two texture coordinates.
  ASSERT_EQ(mesh.positions.size(), 6u);
  const auto corner = [&](std::size_t i) { return mesh.indices[i]; };
  EXPECT_EQ(mesh.normals[corner(0)], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[corner(3)], glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.texcoords[corner(2)], glm::vec2(.5f, 0));
  EXPECT_EQ(mesh.texcoords[corner(4)], glm::vec2(1, 0));
  EXPECT_EQ(mesh.positions[corner(2)], mesh.positions[corner(4)]);
}

TEST_F(MeshTest, ComputesNormalsWhereTheFileHasNoneThatCanBeUsed) {
  for (const std::string bad : {"0 0 0", "nan 0 1", "inf 0 0"}) {
    const Mesh mesh =
        load("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn " + bad + "\nvn 0 1 0\nf 1//1 2//2 3//2\n");
    EXPECT_EQ(mesh.normals[mesh.indices[0]], glm::vec3(0, 0, 1)) << bad;
    EXPECT_EQ(mesh.normals[mesh.indices[1]], glm::vec3(0, 1, 0)) << bad;
    EXPECT_EQ(mesh.warnings.size(), 1u);
  }
}

TEST_F(MeshTest, SmoothsAcrossATextureSeam) {
  // A roof whose ridge 1-2 has different texture coordinates on its two sides.
  const Mesh mesh = load("roof.obj",
                         "v 0 1 0\nv 0 1 -1\nv -1 0 0\nv 1 0 0\nvt 0 0\nvt 1 1\n"
                         "f 1/1 2/1 3/1\nf 2/2 1/2 4/2\n");
  ASSERT_EQ(mesh.positions.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    if (mesh.positions[i].y == 1) {
      EXPECT_NEAR(mesh.normals[i].x, 0, 1e-6);
    }
}

TEST_F(MeshTest, CreaseOverridesTheFilesNormals) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 1 0\nf 1//1 2//1 3//1\n";
  EXPECT_EQ(load("t.obj", text).normals[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(load("t.obj", text, {NormalWeight::angle, 30}).normals[0], glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace scanlit
