// Every bad mesh file gets one line that says where and what, and no more memory than it deserves.
#include <limits>

#include "tests/unit/mesh_files.h"

namespace scanlit {
namespace {

using MeshErrors = MeshFiles;

TEST_F(MeshErrors, FilesThatAreNone) {
  EXPECT_EQ(error_of("absent.obj"), "absent.obj: there is no such file");
  EXPECT_EQ(error_of("empty.ply", ""), "empty.ply: the file is empty");
  EXPECT_EQ(error_of("mesh.dae", "x"),
            "mesh.dae: the name of a mesh file ends in .obj, .ply, .off, .stl or .om");
  EXPECT_EQ(error_of("mesh", "x"),
            "mesh: the name of a mesh file ends in .obj, .ply, .off, .stl or .om");
  std::filesystem::create_directory(in_folder("folder.obj"));
  EXPECT_EQ(error_of("folder.obj"), "folder.obj: is a folder, not a mesh file");
  std::filesystem::create_symlink("/dev/zero", in_folder("zero.stl"));
  EXPECT_EQ(error_of("zero.stl"), "zero.stl: is not a regular file");
}

TEST_F(MeshErrors, FilesWithoutAFace) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(error_of("points.obj", points + "p 1 2 3\nl 1 2\n"), "points.obj: there is no face");
  EXPECT_EQ(error_of("line.obj", points + "f 1 2\n"), "line.obj: there is no face");
  EXPECT_EQ(error_of("p.ply", ascii_ply("0 0 0\n", 1, "", 0)), "p.ply: there is no face");
  EXPECT_EQ(error_of("p.off", "OFF\n1 0 0\n0 0 0\n"), "p.off: there is no face");
  EXPECT_EQ(error_of("p.stl", "solid a\nendsolid a\n"), "p.stl: there is no face");
  EXPECT_EQ(error_of("p.stl", std::string(84, '\0')), "p.stl: there is no face");
  EXPECT_EQ(error_of("p.ply",
                     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                     "y\nproperty float z\nend_header\n0 0 0\n"),
            "p.ply: there is no element 'face'");
}

TEST_F(MeshErrors, VerticesThatDoNotExist) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(error_of("t.obj", points + "\n# face\nf 1 2 9\n"), "t.obj:6: face names vertex 9 of 3");
  EXPECT_EQ(error_of("t.obj", points + "f 1 2 0\n"), "t.obj:4: face names vertex 0 of 3");
  EXPECT_EQ(error_of("t.obj", "f -1 -2 -3\n" + points), "t.obj:1: face names vertex -1 of 0");
  EXPECT_EQ(error_of("t.obj", points + "vt 0 0\nf 1/1 2/2 3/1\n"),
            "t.obj:5: face names texture coordinate 2 of 1");
  EXPECT_EQ(error_of("t.obj", points + "vn 0 0 1\nf 1//1 2//1 3//-2\n"),
            "t.obj:5: face names normal -2 of 1");
  EXPECT_EQ(error_of("t.obj", points + "f 1 2 99999999999999999999\n"),
            "t.obj:4: index '99999999999999999999' is not a whole number");
  EXPECT_EQ(error_of("t.off", "OFF\n4 1 0\n" + tetrahedron_points + "3 0 1 4\n"),
            "t.off:7: face names vertex 4 of 4 (counted from 0)");
  EXPECT_EQ(error_of("t.off", "OFF\n4 1 0\n" + tetrahedron_points + "3 0 1 -1\n"),
            "t.off:7: face names vertex -1 of 4 (counted from 0)");
  EXPECT_EQ(error_of("t.ply", ascii_ply(tetrahedron_points, 4, "3 0 1 4\n", 1)),
            "t.ply:14: face names vertex 4 of 4 (counted from 0)");
}

TEST_F(MeshErrors, CoordinatesThatAreNotFinite) {
  const std::string face = "v 0 1 0\nv 1 0 0\nf 1 2 3\n";
  for (const std::string bad : {"nan", "inf", "-inf", "NaN", "1e39", "1e999"}) {
    EXPECT_EQ(error_of("t.obj", "v 0 " + bad + " 0\n" + face),
              "t.obj:1: vertex coordinate '" + bad + "' is not a finite float");
    EXPECT_EQ(error_of("t.off", "OFF\n1 0 0\n0 0 " + bad),
              "t.off:3: vertex coordinate '" + bad + "' is not a finite float");
    EXPECT_EQ(error_of("t.ply", ascii_ply(bad + " 0 0\n", 1, "3 0 0 0\n", 1)),
              "t.ply:10: a vertex coordinate is not a finite float");
    EXPECT_EQ(error_of("t.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 " + bad),
              "t.stl:4: vertex coordinate '" + bad + "' is not a finite float");
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error_of("t.stl", std::string(80, 'x') + bytes_of(std::uint32_t(1)) +
                                  std::string(44, '\0') + bytes_of(nan) + "xx"),
            "t.stl: triangle 0 (counted from 0): a vertex coordinate is not finite");
  EXPECT_EQ(
      error_of("t.om", "OMT" + bytes_of(std::uint8_t(0x22)) + bytes_of(std::uint32_t(1)) +
                           bytes_of(std::uint32_t(0)) + bytes_of(std::uint32_t(0)) +
                           bytes_of(std::uint16_t(0x1600)) + std::string(8, '\0') + bytes_of(nan)),
      "t.om: vertex 0 (counted from 0): a coordinate is not finite");
  EXPECT_THROW(make_mesh("m", {{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {{0, 1, 2}}), Error);
}

TEST_F(MeshErrors, HeadersThatClaimWhatTheFileCannotHold) {
  EXPECT_EQ(error_of("t.off", "OFF\n3 1000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "t.off:2: the header claims 3 vertices and 1000000000 faces, more than the file's 26 "
            "characters can hold");
  EXPECT_TRUE(error_of("t.ply", ascii_ply("0 0 0\n", 2000000000, "3 0 0 0\n", 1))
                  .starts_with("t.ply:9: the header claims 2000000000 of element 'vertex'"));
  std::string binary = ascii_ply("", 1, "", 2000000000);
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  EXPECT_TRUE(error_of("t.ply", binary + std::string(40, '\0'))
                  .starts_with("t.ply:9: the header claims 2000000000 of element 'face'"));
  EXPECT_EQ(error_of("t.stl", std::string(80, ' ') + bytes_of(0xffffffffu) + std::string(50, '\0')),
            "t.stl: the header claims 4294967295 triangles, the file has room for 1");
  EXPECT_EQ(error_of("t.om", "OMP" + bytes_of(std::uint8_t(0x42)) + bytes_of(0xffffffffu) +
                                 bytes_of(0xffffffffu) + bytes_of(0xffffffffu)),
            "t.om: the header claims 4294967295 vertices, 4294967295 faces and 4294967295 edges, "
            "more than the file's 16 bytes can hold");
}

TEST_F(MeshErrors, ListsAsLongAsNoFileIs) {
  std::string binary = ascii_ply("", 1, "", 1);
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  binary.replace(binary.find("uchar"), 5, "uint");
  EXPECT_EQ(error_of("t.ply", binary + std::string(12, '\0') + bytes_of(0xffffffffu)),
            "t.ply: face 0 of 1 (counted from 0): the file ends here");
  std::string long_face = "300";
  for (int i = 0; i < 300; ++i) long_face += " 0";
  EXPECT_EQ(error_of("t.ply", ascii_ply("0 0 0\n", 1, long_face + "\n", 1)),
            "t.ply:11: a face of 300 corners; at most 255 can be read");
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 10'001; ++i) obj += " 1";
  EXPECT_EQ(error_of("t.obj", obj), "t.obj:4: a face of 10001 corners; at most 10000 can be read");
}

TEST_F(MeshErrors, FilesThatEndEarly) {
  EXPECT_EQ(error_of("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1"),
            "t.obj:3: a vertex has three coordinates");
  EXPECT_EQ(error_of("t.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 0 0 # end of the file\n"),
            "t.off:5: the file ends after 3 of 4 vertices");
  EXPECT_EQ(error_of("t.off", "OFF\n4 1 0\n" + tetrahedron_points + "3 0 1"),
            "t.off:7: face of 3 corners names only 2");
  EXPECT_EQ(error_of("t.off", "OFF"),
            "t.off:1: the file ends before the numbers of vertices and "
            "faces");
  EXPECT_EQ(error_of("t.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"),
            "t.ply:3: the file ends before end_header");
  EXPECT_EQ(error_of("t.ply", ascii_ply(tetrahedron_points, 4, "3 0 1 2\n3 0 1", 2)),
            "t.ply:15: the line ends early");
  EXPECT_EQ(
      error_of("t.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"),
      "t.stl:5: expected the three vertices of a triangle");
  EXPECT_EQ(error_of("t.stl",
                     "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                     "vertex 0 1 0\nendloop\nendfacet\n"),
            "t.stl:8: the file ends before endsolid");
  EXPECT_EQ(error_of("t.om", "OMT"),
            "t.om: an OM file begins with the letters OM and a header of 16 bytes");
  EXPECT_EQ(error_of("t.om", "OMT" + bytes_of(std::uint8_t(0x22)) + std::string(12, '\0') +
                                 bytes_of(std::uint16_t(0x1600))),
            "t.om: the file ends early: 2 bytes expected at byte 18, 0 there");
}

TEST_F(MeshErrors, FilesThatAreSomethingElse) {
  EXPECT_EQ(error_of("t.obj", std::string("\xfe\xff\0v\0 \0", 7)),
            "t.obj: not plain text (it holds zero bytes; save UTF-16 as UTF-8)");
  EXPECT_EQ(error_of("t.obj", "v a b c\n"), "t.obj:1: vertex coordinate 'a' is not a number");
  EXPECT_EQ(error_of("t.obj", "v 0,5 0 0\n"), "t.obj:1: vertex coordinate '0,5' is not a number");
  EXPECT_EQ(error_of("t.obj", "v 0 0 \x1b[31m\n"),
            "t.obj:1: vertex coordinate '?[31m' is not a number");
  EXPECT_EQ(error_of("t.obj", "v 0 0 0\nvt 0\nvn 0 0 1\nf 1/1/1/4 1 1\n"),
            "t.obj:4: a face's corner is VERTEX, VERTEX/TEXCOORD, VERTEX//NORMAL or "
            "VERTEX/TEXCOORD/NORMAL");
  EXPECT_EQ(error_of("t.off", "PNG\n1 1 0\n"), "t.off:1: an OFF file begins with the word OFF");
  EXPECT_EQ(error_of("t.off", "4OFF\n1 1 0\n"),
            "t.off:1: '4OFF': only vertices of three coordinates can be drawn");
  EXPECT_EQ(error_of("t.off", "OFF BINARY\n"),
            "t.off:1: binary OFF cannot be read; save it as text or as PLY");
  EXPECT_EQ(error_of("t.ply", "solid\n"), "t.ply:1: a PLY file begins with the word ply");
  EXPECT_EQ(error_of("t.ply", "ply\nformat utf8 1.0\n"),
            "t.ply:2: unknown format; there are: ascii, binary_little_endian, binary_big_endian");
  EXPECT_EQ(error_of("t.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty flaot x\n"),
            "t.ply:4: unknown type 'flaot'");
  EXPECT_EQ(error_of("t.stl", "ply\n"),
            "t.stl: neither text (it does not begin with solid) nor a "
            "binary STL file (it is shorter than the header)");
  EXPECT_EQ(error_of("t.om", "OMX" + std::string(13, '\0')),
            "t.om: the header says it is neither of triangles, quads nor polygons");
}

TEST_F(MeshErrors, OmTopologyThatWouldLeadAstray) {
  // One triangle: three edges, of each pair of halfedges the first belongs to the face.
  const auto triangle = [](std::int8_t next_of_first, std::int8_t vertex, std::int8_t face) {
    std::string bytes = "OMP" + bytes_of(std::uint8_t(0x42)) + bytes_of(std::uint32_t(3)) +
                        bytes_of(std::uint32_t(1)) + bytes_of(std::uint32_t(3)) +
                        bytes_of(std::uint16_t(0x1600));
    for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) bytes += bytes_of(x);
    bytes += bytes_of(std::uint16_t(6 << 2 | 7 << 5));
    for (const int i : {int(next_of_first), int(vertex), 0, 5, 0, -1, 4, 2, 0, 1, 1, -1, 0, 0,
                        int(face), 3, 2, -1})
      bytes += bytes_of(std::int8_t(i));
    bytes += bytes_of(std::uint16_t(0 << 2 | 7 << 5)) + std::string("\0\2\4", 3);
    bytes += bytes_of(std::uint16_t(2 << 2 | 7 << 5)) + std::string("\0", 1);
    return bytes + bytes_of(std::uint16_t(0x1c));
  };
  EXPECT_EQ(load("good.om", triangle(2, 1, 0)).triangle_count(), 1u);
  EXPECT_EQ(error_of("t.om", triangle(6, 1, 0)), "t.om: names halfedge 6 of 6 (counted from 0)");
  EXPECT_EQ(error_of("t.om", triangle(4, 1, 0)),
            "t.om: malformed: two halfedges are followed by the same one");
  EXPECT_EQ(error_of("t.om", triangle(2, 3, 0)), "t.om: names vertex 3 of 3 (counted from 0)");
  EXPECT_EQ(error_of("t.om", triangle(2, 1, -1)),
            "t.om: malformed: face 0 (counted from 0) shares its outline with another");
}

TEST(MakeMeshErrors, NamesTheFace) {
  try {
    make_mesh("m", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "m: face 1 names vertex 3 of 3 (counted from 0)");
  }
  EXPECT_THROW(make_mesh("m", {}, {}), Error);
}

TEST(DidYouMean, NamesTheNearestWhereItIsNear) {
  const std::vector<std::string> models = {"lambert", "phong", "blinn-phong"};
  EXPECT_EQ(did_you_mean("blin-phong", models), "; did you mean 'blinn-phong'?");
  EXPECT_EQ(did_you_mean("phnog", models), "; did you mean 'phong'?");
  EXPECT_EQ(did_you_mean("fong", models), "; there are: lambert, phong, blinn-phong");
  EXPECT_EQ(did_you_mean("pong", models), "; did you mean 'phong'?");
  EXPECT_EQ(did_you_mean("", models), "; there are: lambert, phong, blinn-phong");
  EXPECT_EQ(did_you_mean("n", {"m", "ks"}), "; there are: m, ks");
  EXPECT_EQ(did_you_mean("x", {}), "");
}

}  // namespace
}  // namespace scanlit
