// Mesh files written by the tests themselves.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "rasterizer/error.h"
#include "rasterizer/mesh.h"

namespace scanlit {

class MeshFiles : public testing::Test {
 protected:
  MeshFiles() { std::filesystem::create_directories(folder_); }
  ~MeshFiles() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path in_folder(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(in_folder(name), std::ios::binary) << bytes;
    return in_folder(name);
  }

  Mesh load(const std::string& name, const std::string& bytes,
            const MeshOptions& options = {}) const {
    return load_mesh(write(name, bytes), options);
  }

  /// What load_mesh says, the folder's name left out.
  std::string error_of(const std::string& name) const {
    try {
      load_mesh(in_folder(name));
    } catch (const Error& error) {
      const std::string what = error.what(), folder = folder_.string() + "/";
      return what.starts_with(folder) ? what.substr(folder.size()) : what;
    }
    return "no error";
  }
  std::string error_of(const std::string& name, const std::string& bytes) const {
    write(name, bytes);
    return error_of(name);
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("scanlit-mesh-" + std::to_string(getpid()));
};

/// The bytes of a value, least significant first.
template <class T>
std::string bytes_of(T value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A tetrahedron with a corner in the origin and legs of length 1, as four faces seen from outside.
inline const std::string tetrahedron_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
inline const std::string tetrahedron_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

inline std::string ascii_ply(const std::string& points, int vertex_count, const std::string& faces,
                             int face_count) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertex_count) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(face_count) + "\nproperty list uchar int vertex_indices\nend_header\n" +
         points + faces;
}

}  // namespace scanlit
