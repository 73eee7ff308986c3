#include "lessons/assignments/grade/json_text.h"
#include "lessons/assignments/grade/writers.h"
#include "lessons/studio/html.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments {
namespace {

/// In an attribute a line end would be read as a blank.
std::string attribute(const char* name, const std::string& text) {
  std::string escaped = studio::escape_html(plain_text(text));
  for (std::size_t at = 0; (at = escaped.find('\n', at)) != escaped.npos;)
    escaped.replace(at, 1, "&#10;");
  return std::string(" ") + name + "=\"" + escaped + '"';
}

std::string count(const char* name, std::size_t number) {
  return attribute(name, std::to_string(number));
}

std::string test_case(const std::string& assignment, const ScoredPart& part) {
  const bool missing = part.points < part.max_points;
  std::string text = "    <testcase" + attribute("classname", assignment) +
                     attribute("name", part.id + " " + part.name);
  if (!missing) return text + "/>\n";
  if (part.manual && !part.by_hand) return text + "><skipped/></testcase>\n";
  return text + ">\n      <failure" +
         attribute("message", studio::text_of(part.points) + " of " +
                                  studio::text_of(part.max_points) + " points") +
         ">" + studio::escape_html(plain_text(part.message)) + "</failure>\n    </testcase>\n";
}

}  // namespace

std::string junit_xml(const std::string& assignment, const std::vector<Grade>& grades) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
                     attribute("name", assignment) + ">\n";
  for (const Grade& grade : grades) {
    std::size_t failures = 0, skipped = 0;
    std::string cases;
    for (const ScoredPart& part : grade.parts) {
      const bool open = part.manual && !part.by_hand && part.points < part.max_points;
      skipped += open;
      failures += part.points < part.max_points && !open;
      cases += test_case(assignment, part);
    }
    text += "  <testsuite" + attribute("name", grade.submission) +
            count("tests", grade.parts.size()) + count("failures", failures) + count("errors", 0) +
            count("skipped", skipped) + ">\n" + cases + "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

}  // namespace scanlit::assignments
