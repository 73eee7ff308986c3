// Who does the least work: the file leaderboard.csv. Times are in it, so it is another one each
// time, and nothing is reckoned from it.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lessons/assignments/grade/score.h"

namespace scanlit::assignments {

/// As times.json keeps it.
nlohmann::json effort_json(const Effort& effort);

/// A row for each submission in whose folder below `results` times.json holds an effort: fewest
/// evaluations first, then fewest instructions, then the shortest time.
std::string leaderboard_csv(const std::filesystem::path& results, const std::vector<Grade>& grades);

}  // namespace scanlit::assignments
