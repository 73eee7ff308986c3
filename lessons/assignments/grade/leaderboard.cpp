#include "lessons/assignments/grade/leaderboard.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "lessons/assignments/grade/csv.h"
#include "lessons/assignments/grade/json_text.h"

namespace scanlit::assignments {
namespace {

struct Entry {
  std::string submission;
  Effort effort;
};

std::optional<Effort> read_effort(const std::filesystem::path& times) {
  const nlohmann::json read = nlohmann::json::parse(std::ifstream(times), nullptr, false);
  if (!read.is_object() || !read.contains("effort")) return std::nullopt;
  const nlohmann::json& effort = read["effort"];
  return Effort{.evaluations = effort.value("evaluations", std::int64_t(0)),
                .fragments = effort.value("fragments", std::int64_t(0)),
                .instructions = effort.value("instructions", std::int64_t(0)),
                .seconds = effort.value("seconds", 0.0)};
}

}  // namespace

nlohmann::json effort_json(const Effort& effort) {
  return {{"evaluations", effort.evaluations},
          {"fragments", effort.fragments},
          {"instructions", effort.instructions},
          {"seconds", effort.seconds}};
}

std::string leaderboard_csv(const std::filesystem::path& results,
                            const std::vector<Grade>& grades) {
  std::vector<Entry> entries;
  for (const Grade& grade : grades)
    if (const auto effort = read_effort(results / grade.folder / "times.json"))
      entries.push_back({grade.submission, *effort});
  std::ranges::stable_sort(entries, {}, [](const Entry& entry) {
    const Effort& e = entry.effort;
    return std::tuple(e.evaluations, e.instructions, e.seconds);
  });
  std::string text =
      csv_line({"Submission", "Evaluations", "Fragments", "Instructions", "Seconds"});
  for (const Entry& entry : entries)
    text += csv_line(
        {csv_text(plain_text(entry.submission)), csv_number(double(entry.effort.evaluations)),
         csv_number(double(entry.effort.fragments)),
         entry.effort.instructions > 0 ? csv_number(double(entry.effort.instructions)) : "",
         csv_number(std::round(entry.effort.seconds * 1e6) / 1e6)});
  return text;
}

}  // namespace scanlit::assignments
