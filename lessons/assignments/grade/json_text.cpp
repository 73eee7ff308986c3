#include "lessons/assignments/grade/json_text.h"

#include <nlohmann/json.hpp>

#include "lessons/studio/html.h"

namespace scanlit::assignments {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace

std::string json_text(const nlohmann::json& value) {
  return value.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + '\n';
}

std::string plain_text(const std::string& text) {
  // escape_html() knows which bytes are text; what it escapes beside them comes back.
  std::string plain = studio::escape_html(text);
  for (const auto& [code, character] :
       {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&quot;", "\""},
        std::pair{"&#39;", "'"}, std::pair{"&amp;", "&"}})
    replace_all(plain, code, character);
  // The two code points that XML has no way to write at all.
  for (const char* none : {"\xef\xbf\xbe", "\xef\xbf\xbf"})
    replace_all(plain, none, "\xef\xbf\xbd");
  return plain;
}

}  // namespace scanlit::assignments
