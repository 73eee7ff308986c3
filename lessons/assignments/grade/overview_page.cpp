#include <algorithm>

#include "lessons/assignments/grade/writers.h"
#include "lessons/studio/html.h"
#include "lessons/studio/text.h"

namespace scanlit::assignments {
namespace {

using studio::escape_html;

/// No script at all, and nothing from elsewhere, whatever a name smuggles in.
constexpr const char* head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src 'self' data:; style-src 'unsafe-inline'">
<style>
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem; color: #222; }
ul { padding-left: 1.2rem; color: #555; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(16rem, 1fr)); gap: 1rem; }
article { border: 1px solid #ccc; border-radius: 6px; padding: .7rem; overflow-wrap: anywhere; }
article img { width: 100%; background: #000; image-rendering: pixelated; }
.none { aspect-ratio: 4/3; background: #eee; color: #777; display: grid; place-items: center; }
h2 { font-size: 1rem; margin: .4rem 0 .2rem; }
.bars { display: flex; gap: 2px; height: .6rem; }
.bars span { flex: 1; background: #e3c6c0; position: relative; }
.bars i { position: absolute; inset: 0 auto 0 0; background: #4c8c5a; }
.note { color: #a33; }
</style>
)";

std::string bar(const ScoredPart& part) {
  const double share = part.max_points > 0 ? part.points / part.max_points : 1;
  const std::string percent = studio::fixed(100 * std::clamp(share, 0.0, 1.0), 0);
  return "<span title=\"" + escape_html(part.id + " " + part.name) + ": " +
         studio::text_of(part.points) + " of " + studio::text_of(part.max_points) +
         "\"><i style=\"width:" + percent + "%\"></i></span>";
}

/// '%' of a folder's name is a character of the file's name, not an escape of the URL.
std::string url(const std::string& path) {
  std::string result;
  for (const char c : path) result += c == '%' ? "%25" : std::string(1, c);
  return escape_html(result);
}

std::string people(const Grade& grade) {
  std::string names;
  for (const Student& student : grade.students)
    if (student.name != grade.submission)
      names += (names.empty() ? "" : ", ") + escape_html(student.name);
  return names.empty() ? "" : "<div>" + names + "</div>";
}

std::string card(const Grade& grade) {
  std::string text = "<article>";
  if (!grade.picture.empty())
    text += "<img src=\"" + url(grade.picture) + "\" alt=\"drawn by this submission\">";
  else
    text += std::string("<div class=\"none\">") +
            (!grade.handed_in ? "nothing handed in"
             : grade.built    ? "no picture"
                              : "not built") +
            "</div>";
  const std::string name = escape_html(grade.submission);
  text +=
      "<h2>" +
      (grade.handed_in ? "<a href=\"" + url(grade.folder + "/report.html") + "\">" + name + "</a>"
                       : name) +
      "</h2>" + people(grade);
  text += "<div><b>" + studio::text_of(grade.total) + "</b> of " +
          studio::text_of(grade.max_points) + "</div><div class=\"bars\">";
  for (const ScoredPart& part : grade.parts) text += bar(part);
  text += "</div>";
  if (grade.late_days > 0)
    text += "<div>" + std::to_string(grade.late_days) + (grade.late_days == 1 ? " day" : " days") +
            " late</div>";
  if (!grade.comment.empty()) text += "<div>" + escape_html(grade.comment) + "</div>";
  if (!grade.fault.empty())
    text += "<div class=\"note\">The judge failed: " + escape_html(grade.fault) + "</div>";
  return text + "</article>\n";
}

}  // namespace

std::string overview_page(const std::string& title, const std::vector<Grade>& grades,
                          const std::vector<std::string>& about) {
  std::string text = head;
  text += "<title>" + escape_html(title) + "</title></head><body>\n<h1>" + escape_html(title) +
          "</h1>\n<ul>";
  for (const std::string& line : about) text += "<li>" + escape_html(line) + "</li>";
  text += "</ul>\n<main>\n";
  for (const Grade& grade : grades) text += card(grade);
  return text + "</main></body></html>\n";
}

}  // namespace scanlit::assignments
