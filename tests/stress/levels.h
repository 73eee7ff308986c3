// The same pictures at every level of vectors: drawn into a file by the program of one level,
// compared by another's.
#pragma once

#include <string>

namespace scanlit::stress {

/// Draws `count` random scenes into a file. Throws std::runtime_error where it cannot be written.
void write_pictures(const std::string& file, int count);

/// Prints how the pictures of two files differ. True where coverage, ids and depth are the same to
/// the bit, and no channel of no pixel by more than one step of 8-bit sRGB.
bool pictures_agree(const std::string& one, const std::string& other);

}  // namespace scanlit::stress
