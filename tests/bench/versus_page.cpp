// The page: per number of threads a chart of the ratios, then the table.
#include <algorithm>
#include <cstdio>
#include <map>

#include "report.h"
#include "versus_report.h"

namespace scanlit::bench {

namespace {

template <class... Values>
std::string format(const char* pattern, const Values&... values) {
  char text[600];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

constexpr int bar_height = 18, row_height = 24, label_width = 100, chart_width = 760;

/// Name, figure and bar of llvmpipe's time over Scanlit's, with a line where both are equal.
std::string chart(const std::vector<SceneResult>& results) {
  double largest = 1;
  for (const SceneResult& r : results)
    if (r.same) largest = std::max(largest, r.ratio());
  const double unit = (chart_width - label_width - 10) / largest, equal = label_width + unit;
  const int bottom = row_height * int(results.size());
  std::string svg =
      format("<svg width='%d' height='%d' font-size='13'>\n", chart_width, bottom + row_height);
  int y = 0;
  for (const SceneResult& r : results) {
    svg += format("<text x='0' y='%d'>%s</text>", y + 14, r.scene.c_str());
    if (r.same)
      svg += format(
          "<text x='%d' y='%d' text-anchor='end'>%.2f</text>"
          "<rect x='%d' y='%d' width='%.1f' height='%d' fill='#4a7db0'/>\n",
          label_width - 12, y + 14, r.ratio(), label_width, y, r.ratio() * unit, bar_height);
    else
      svg += format("<text x='%d' y='%d'>pictures differ</text>\n", label_width, y + 14);
    y += row_height;
  }
  return svg + format(
                   "<line x1='%.1f' x2='%.1f' y1='0' y2='%d' stroke='#000'/>"
                   "<text x='%.1f' y='%d' text-anchor='middle'>equal</text></svg>\n",
                   equal, equal, bottom, equal, bottom + 14);
}

std::string table(const std::vector<SceneResult>& results) {
  std::string html =
      "<table><tr><th>scene<th>Scanlit ms<th>least<th>processor<th>llvmpipe ms<th>least"
      "<th>processor<th>with glReadPixels<th>a memset (S0), Scanlit without reuse "
      "(S10)<th>ratio<th>max difference<th>mean<th>covered</tr>\n";
  for (const SceneResult& r : results) {
    html += "<tr><td>" + r.scene;
    for (const FrameTime& t : {r.scanlit, r.buffer})
      html += format("<td>%.2f<td>%.2f<td>%.2f", t.median_ms, t.min_ms, t.cpu_ms);
    html += format("<td>%.2f", r.framebuffer_object.median_ms);
    html += r.yardstick ? format("<td>%.2f", r.yardstick->median_ms) : "<td>";
    html += r.same ? format("<td>%.2f", r.ratio()) : "<td>" + r.difference;
    html += format("<td>%.0f<td>%.3f<td>%lld</tr>\n", r.max_difference, r.mean_difference,
                   static_cast<long long>(r.covered[0]));
  }
  return html + "</table>\n";
}

std::string target_table(const std::vector<TargetResult>& reached) {
  std::string html =
      "<h2>Targets, two threads</h2>\n"
      "<table><tr><th>what<th>wanted<th>medians<th>least times<th><th>worst</tr>\n";
  for (const TargetResult& t : reached)
    html += format("<tr><td>%s<td>%s %.1f<td>%.2f<td>%.2f<td>%s<td>%s</tr>\n", t.what.c_str(),
                   t.at_least ? "at least" : "at most", t.wanted, t.by_median, t.by_least,
                   t.met() ? "met" : "not met", t.worst.c_str());
  return html + "</table>\n";
}

}  // namespace

std::string report_page(const std::vector<SceneResult>& results,
                        const std::vector<TargetResult>& reached) {
  std::map<int, std::vector<SceneResult>> by_threads;
  for (const SceneResult& result : results) by_threads[result.threads].push_back(result);
  std::string html =
      "<!doctype html><meta charset='utf-8'><title>Scanlit beside llvmpipe</title>\n"
      "<style>body{font:15px sans-serif;margin:2em}td,th{padding:2px 10px;text-align:right}"
      "th{vertical-align:bottom}</style>\n"
      "<h1>Scanlit beside llvmpipe</h1>\n<p>How many times faster a frame of 1920x1080 is: "
      "llvmpipe's time over Scanlit's, medians. " +
      machine() + "; Scanlit's vectors: " + vector_level() + "; ";
  if (!results.empty()) html += results.front().peer;
  html += ".</p>\n";
  for (const auto& [threads, part] : by_threads)
    html += format("<h2>%d thread%s</h2>\n", threads, threads > 1 ? "s" : "") + chart(part) +
            table(part);
  return html + target_table(reached);
}

}  // namespace scanlit::bench
