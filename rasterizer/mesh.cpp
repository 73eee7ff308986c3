#include "rasterizer/mesh.h"

#include <cctype>
#include <fstream>
#include <mutex>
#include <sstream>
#include <utility>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_closed.h"
#include "rasterizer/mesh/mesh_file.h"
#include "rasterizer/mesh/mesh_flatten.h"
#include "rasterizer/mesh/poly_mesh.h"

namespace scanlit {
namespace {

using namespace detail;

struct FileFormat {
  std::string suffix;
  CheckedFile (*check)(const std::string& name, std::string_view bytes);
};

const std::vector<FileFormat>& formats() {
  static const std::vector<FileFormat> all = {{"obj", check_obj},
                                              {"ply", check_ply},
                                              {"off", check_off},
                                              {"stl", check_stl},
                                              {"om", check_om}};
  return all;
}

/// While it lives, OpenMesh prints nothing: what it has to say of a face, Repairs counts.
class QuietOpenMesh {
 public:
  QuietOpenMesh() {
    omerr().disable();
    omlog().disable();
  }
  ~QuietOpenMesh() {
    omerr().enable();
    omlog().enable();
  }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;
};

std::string read_file(const std::filesystem::path& file, const std::string& name) {
  constexpr std::uintmax_t max_bytes = std::uintmax_t(4) << 30;  // bounds the memory of all to come
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw Error(name, "there is no such file");
  if (error) throw Error(name, error.message());
  if (std::filesystem::is_directory(status)) throw Error(name, "is a folder, not a mesh file");
  if (!std::filesystem::is_regular_file(status)) throw Error(name, "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (size == 0) throw Error(name, "the file is empty");
  if (size > max_bytes) throw Error(name, "the file is larger than 4 GiB");

  std::string bytes(size, '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(name, "cannot be opened for reading");
  if (!in.read(bytes.data(), std::streamsize(size))) throw Error(name, "cannot be read");
  return bytes;
}

const FileFormat& format_of(const std::filesystem::path& file, const std::string& name) {
  std::string suffix = file.extension().string();
  for (char& c : suffix) c = char(std::tolower(static_cast<unsigned char>(c)));
  for (const FileFormat& format : formats())
    if (suffix == "." + format.suffix) return format;
  throw Error(name, "the name of a mesh file ends in .obj, .ply, .off, .stl or .om");
}

/// Prepares the mesh for what the file has and says the same to OpenMesh.
OpenMesh::IO::Options request_attributes(const CheckedFile& file, PolyMesh& mesh) {
  using OpenMesh::IO::Options;
  Options options;
  if (file.binary) options += Options::Binary;
  if (file.vertex_normals || file.corner_normals) options += Options::VertexNormal;
  if (file.vertex_texcoords) options += Options::VertexTexCoord;
  if (file.corner_texcoords) options += Options::FaceTexCoord;
  if (file.vertex_normals || !file.normals.empty()) mesh.request_vertex_normals();
  if (file.corner_normals) mesh.request_halfedge_normals();
  if (file.vertex_texcoords || !file.texcoords.empty()) mesh.request_vertex_texcoords2D();
  if (file.corner_texcoords) mesh.request_halfedge_texcoords2D();
  if (!file.colours.empty()) mesh.request_vertex_colors();
  return options;
}

void read_with_openmesh(CheckedFile& file, const std::string& suffix, const std::string& name,
                        PolyMesh& mesh, MeshImporter& importer) {
  OpenMesh::IO::Options options = request_attributes(file, mesh);
  const QuietOpenMesh quiet;
  std::istringstream in(std::move(file.data));
  if (!OpenMesh::IO::IOManager().read(in, "." + suffix, importer, options))
    throw Error(name, "OpenMesh cannot read it");
  const std::size_t taken = mesh.n_faces() + importer.repairs().dropped - file.repairs.dropped;
  if (taken != file.faces)
    throw Error(name, "OpenMesh read only " + std::to_string(taken) + " of " +
                          std::to_string(file.faces) + " faces");
  for (std::size_t i = 0; i < file.normals.size(); ++i)
    mesh.set_normal(OpenMesh::VertexHandle(int(i)), to_openmesh(file.normals[i]));
  for (std::size_t i = 0; i < file.texcoords.size(); ++i)
    mesh.set_texcoord2D(OpenMesh::VertexHandle(int(i)), to_openmesh(file.texcoords[i]));
  for (std::size_t i = 0; i < file.colours.size(); ++i)
    mesh.set_color(OpenMesh::VertexHandle(int(i)), to_openmesh(file.colours[i]));
  importer.complete_copies();
}

/// The flat mesh with all that can be said of it.
Mesh finished(const PolyMesh& mesh, MeshImporter& importer, std::string name,
              const MeshOptions& options) {
  Mesh result = flatten(mesh, importer.originals(), std::move(name), options);
  const std::vector<std::string> repairs = importer.repairs().warnings();
  result.warnings.insert(result.warnings.begin(), repairs.begin(), repairs.end());
  const Closedness closedness = detail::closedness(result);
  result.closed = closedness == Closedness::outward;
  if (closedness == Closedness::inside_out)
    result.warnings.push_back("it is inside out: its faces are clockwise seen from outside");
  return result;
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& file, const MeshOptions& options) {
  // OpenMesh's readers keep the state of the file they read.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);

  const std::string name = file.string();
  const FileFormat& format = format_of(file, name);
  PolyMesh mesh;
  CheckedFile checked = format.check(name, read_file(file, name));
  MeshImporter importer(mesh, checked.repairs);
  read_with_openmesh(checked, format.suffix, name, mesh, importer);
  return finished(mesh, importer, name, options);
}

Mesh make_mesh(std::string name, const std::vector<glm::vec3>& positions,
               const std::vector<std::vector<std::uint32_t>>& faces, const MeshOptions& options) {
  PolyMesh mesh;
  MeshImporter importer(mesh);
  const QuietOpenMesh quiet;
  for (const glm::vec3& p : positions) mesh.add_vertex(to_openmesh(p));
  MeshImporter::VHandles corners;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    corners.clear();
    for (const std::uint32_t v : faces[f]) {
      if (v >= positions.size())
        throw Error(name, "face " + std::to_string(f) + " names vertex " + std::to_string(v) +
                              " of " + std::to_string(positions.size()) + " (counted from 0)");
      corners.emplace_back(int(v));
    }
    importer.add_face(corners);
  }
  return finished(mesh, importer, std::move(name), options);
}

}  // namespace scanlit
