// What OpenMesh's readers get to see of a mesh file.
//
// They take files on trust: a header that claims a billion faces keeps them busy for minutes, a
// PLY header without an end for ever; "nan" where a number should be stops the parsing without a
// word, or shifts all later normals by one; indices are used unchecked. So each file is first read
// by a checker of its own, which throws an Error that names the line, and copies what the engine
// uses, and nothing else, in the same format, for OpenMesh to read from memory.
#pragma once

#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/mesh/poly_mesh.h"

namespace scanlit::detail {

struct CheckedFile {
  std::string data;             // what OpenMesh reads
  std::size_t faces = 0;        // in data
  bool binary = false;          // STL: which of its two formats
  bool vertex_normals = false;  // data holds some
  bool vertex_texcoords = false;
  bool corner_normals = false;  // OBJ
  bool corner_texcoords = false;
  // OFF: by vertex, not in data. OpenMesh learns of them from the name of a file only.
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> texcoords;
  // Of every format that has them: linear RGB, by vertex of data, not in data. OpenMesh would round
  // them to 8 bits.
  std::vector<glm::vec3> colours;
  Repairs repairs;  // done already
};

// `name` is the file's, for messages. All throw Error.
CheckedFile check_obj(const std::string& name, std::string_view text);
CheckedFile check_off(const std::string& name, std::string_view text);
CheckedFile check_ply(const std::string& name, std::string_view bytes);
CheckedFile check_stl(const std::string& name, std::string_view bytes);
CheckedFile check_om(const std::string& name, std::string_view bytes);

/// The lines of a text file as words. Knows \n, \r\n and \r; skips a UTF-8 byte order mark, empty
/// lines and comments (a word that begins with # and all after it).
class Lines {
 public:
  /// A line that ends in a backslash goes on in the next one only where `continued`.
  Lines(std::string name, std::string_view text, bool continued = false);

  /// To the next line that has words; false at the end.
  bool next();

  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view rest() const { return text_.substr(position_); }  // after this line

  /// Throws Error "name:line: what". After the end, the line is the last one.
  [[noreturn]] void fail(const std::string& what) const;
  void expect_words(std::size_t at_least, const std::string& what) const;

  /// The word as a number; a failure names it by `what` ("vertex coordinate").
  float finite(std::size_t word, const char* what) const;
  double any_number(std::size_t word, const char* what) const;  // NaN and Inf too
  std::int64_t integer(std::size_t word, const char* what) const {
    return integer(words_[word], what);
  }
  std::int64_t integer(std::string_view word, const char* what) const;

 private:
  bool split_line();

  std::string name_;
  std::string_view text_;
  std::size_t position_ = 0;
  bool continued_;
  std::size_t line_ = 0, next_line_ = 1;
  std::vector<std::string_view> words_;
};

/// The text with ? for everything but printable ASCII: what files hold may end up on a terminal.
std::string printable(std::string_view text);

/// Throws where the text holds a zero byte, as UTF-16 does and a binary file mostly.
void expect_text(const std::string& name, std::string_view text);

/// Appends the shortest text that reads back as the same float, and a space.
void append_number(std::string& text, float value);
void append_number(std::string& text, std::int64_t value);

/// Appends the value's bytes, least significant first.
template <class T>
void append_bytes(std::string& bytes, T value) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace scanlit::detail
