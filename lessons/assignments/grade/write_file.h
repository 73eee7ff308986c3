// Small files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace scanlit::assignments {

/// Throws Error where it cannot be written.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace scanlit::assignments
