#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/report.h"
#include "lessons/studio/html.h"

namespace scanlit::assignments {
namespace {

using studio::escape_html;

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>%TITLE%</title><style>
body { font: 16px/1.45 "DejaVu Sans", Verdana, Arial, sans-serif; max-width: 1100px;
       margin: 24px auto; padding: 0 16px; color: #222; }
table { border-collapse: collapse; width: 100%; }
td, th { text-align: left; vertical-align: top; padding: 6px 10px; border-bottom: 1px solid #ccc; }
td.points, th.points { text-align: right; white-space: nowrap; }
.passed { color: #1a6b2d; } .failed { color: #a3241c; font-weight: bold; }
.part { color: #8a5a00; font-weight: bold; white-space: nowrap; }
th.name { width: 70%; }
tr.said td { padding-top: 0; } tr.saying td { border-bottom: none; }
pre { font: 13px/1.3 "DejaVu Sans Mono", Menlo, Consolas, monospace; margin: 6px 0 0;
      white-space: pre-wrap; }
.compare { margin: 8px 0 32px; }
.compare .bar { display: flex; gap: 6px; align-items: center; margin-bottom: 8px; flex-wrap: wrap; }
button { font: inherit; padding: 3px 12px; border: 1px solid #888; background: #f4f4f4;
         border-radius: 4px; cursor: pointer; }
button[aria-pressed=true] { background: #264b7d; color: #fff; border-color: #264b7d; }
.view { display: inline-block; overflow: auto; max-width: 100%; max-height: 80vh;
        border: 1px solid #888; }
[hidden] { display: none !important; }
.stack { position: relative; }
.stack img { position: absolute; left: 0; top: 0; image-rendering: pixelated; display: block; }
.stack .line { position: absolute; top: 0; bottom: 0; width: 2px; margin-left: -1px;
               background: #f5d76e; }
.where { color: #555; font-size: 13px; min-height: 1.4em; }
</style></head><body>
)";

/// Without scripts the three pictures stand below each other.
constexpr const char* script = R"(<script>
for (const box of document.querySelectorAll(".compare")) {
  const [fresh, reference, difference] = box.querySelectorAll(".stack img");
  const stack = box.querySelector(".stack"), line = box.querySelector(".line");
  const slider = box.querySelector("input[type=range]"), where = box.querySelector(".where");
  const buttons = [...box.querySelectorAll("button[data-show]")];
  const width = +box.dataset.width, height = +box.dataset.height;
  let zoom = Math.max(1, Math.min(16, Math.floor(720 / width))), shown = "slider";
  const show = () => {
    for (const img of [fresh, reference, difference]) {
      img.style.width = width * zoom + "px";
      img.style.height = height * zoom + "px";
    }
    stack.style.width = width * zoom + "px";
    stack.style.height = height * zoom + "px";
    const cut = slider.value / 100;
    fresh.hidden = !(shown == "new" || shown == "slider");
    reference.hidden = !(shown == "reference" || shown == "slider");
    difference.hidden = shown != "difference";
    reference.style.clipPath = shown == "slider" ? `inset(0 0 0 ${cut * 100}%)` : "none";
    line.hidden = slider.parentElement.hidden = shown != "slider";
    line.style.left = cut * width * zoom + "px";
    for (const b of buttons) b.setAttribute("aria-pressed", b.dataset.show == shown);
    box.querySelector(".zoom").textContent = zoom + "x";
  };
  for (const b of buttons) b.onclick = () => { shown = b.dataset.show; show(); };
  slider.oninput = show;
  box.querySelector(".in").onclick = () => { zoom = Math.min(32, zoom * 2); show(); };
  box.querySelector(".out").onclick = () => { zoom = Math.max(1, zoom / 2); show(); };
  stack.onmousemove = e => {
    const r = stack.getBoundingClientRect();
    const x = Math.floor((e.clientX - r.left) / zoom), y = Math.floor((e.clientY - r.top) / zoom);
    where.textContent = `column ${x}, row ${y} (from the top)`;
    if (shown == "slider" && e.buttons) {
      slider.value = 100 * (e.clientX - r.left) / (width * zoom);
      show();
    }
  };
  show();
}
</script>
)";

std::string image(const JudgedPicture& picture, const std::vector<std::uint8_t>& rgb,
                  const char* what) {
  return std::string("<img alt=\"") + what + "\" draggable=\"false\" src=\"" +
         studio::png_url(picture_of(picture.width, picture.height, rgb)) + "\">";
}

std::string compare(const JudgedPicture& picture) {
  return "<h2>" + escape_html(picture.title) + "</h2>\n<div class=\"compare\" data-width=\"" +
         std::to_string(picture.width) + "\" data-height=\"" + std::to_string(picture.height) +
         "\"><div class=\"bar\"><button data-show=\"new\">Yours</button>"
         "<button data-show=\"reference\">Should be</button>"
         "<button data-show=\"difference\">Difference</button>"
         "<button data-show=\"slider\">Slider</button>"
         "<label>Yours <input type=\"range\" min=\"0\" max=\"100\" value=\"50\"> Should be</label>"
         "<button class=\"out\" title=\"smaller\">&minus;</button><span class=\"zoom\"></span>"
         "<button class=\"in\" title=\"larger\">+</button></div>\n"
         "<div class=\"view\"><div class=\"stack\">" +
         image(picture, picture.fresh, "Yours") + "\n" +
         image(picture, picture.reference, "Should be") + "\n" +
         image(picture, picture.difference, "Difference") +
         "<div class=\"line\"></div></div></div><div class=\"where\"></div></div>\n";
}

std::string row(const TestScore& test, bool built) {
  std::string message;
  if (built && !test.hidden && !test.message.empty()) {
    message = "<pre>" + escape_html(test.message) + "</pre>";
    if (!test.printed.empty())
      message += "<details><summary>What your program printed</summary><pre>" +
                 escape_html(test.printed) + "</pre></details>";
  }
  const std::string how = test.points >= test.max_points ? "passed\">passed"
                          : test.points > 0              ? "part\">in part"
                                                         : "failed\">failed";
  const std::string opened = message.empty() ? "<tr>" : "<tr class=\"saying\">";
  return opened + "<td>" + escape_html(test.id) + "</td><td>" + escape_html(test.name) +
         "</td><td class=\"" + how + "</td><td class=\"points\">" + points_text(test.points) +
         " of " + points_text(test.max_points) + "</td></tr>\n" +
         (message.empty()
              ? ""
              : "<tr class=\"said\"><td></td><td colspan=\"3\">" + message + "</td></tr>\n");
}

}  // namespace

std::string report_page(const Assignment& assignment, const Verdict& verdict) {
  const std::string title = assignment.id + ", " + assignment.title;
  std::string page = head;
  page.replace(page.find("%TITLE%"), 7, escape_html(title));
  page += "<h1>" + escape_html(title) + "</h1>\n<p>Variant " + std::to_string(verdict.seed) +
          ": <b>" + points_text(points(verdict)) + " of " + points_text(max_points(verdict)) +
          " points</b>.</p>\n<table><tr><th>Test</th><th class=\"name\"></th><th>Result</th>"
          "<th class=\"points\">Points</th></tr>\n";
  for (const TestScore& test : verdict.tests) page += row(test, verdict.built);
  page += "</table>\n";
  if (verdict.effort) page += "<p>" + effort_text(*verdict.effort) + "</p>\n";
  if (!verdict.built && !verdict.tests.empty())
    page += "<p>" + escape_html(verdict.tests.front().message) + "</p>\n<pre>" +
            escape_html(verdict.build_log) + "</pre>\n";
  for (const JudgedPicture& picture : verdict.pictures) page += compare(picture);
  return page + script + "</body></html>\n";
}

}  // namespace scanlit::assignments
