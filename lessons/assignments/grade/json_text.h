// JSON that every reader takes, whatever bytes students wrote into it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace scanlit::assignments {

/// Bytes that are no UTF-8 become U+FFFD, numbers that are not finite null.
std::string json_text(const nlohmann::json& value);

/// What is left of text for people when control characters, escape sequences' beginnings and bytes
/// that are no UTF-8 are replaced by U+FFFD; tabs and line ends stay. Also all that XML 1.0 allows.
std::string plain_text(const std::string& text);

}  // namespace scanlit::assignments
