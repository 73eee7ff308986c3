#include "lessons/assignments/grade/result.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lessons/assignments/grade/json_text.h"
#include "lessons/assignments/grade/write_file.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/studio/fingerprint.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"

namespace scanlit::assignments {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* result_file = "result.json";
constexpr int format = 1;

json to_json(const Result& result) {
  json tests = json::array(), pictures = json::array();
  for (const TestResult& test : result.tests)
    tests.push_back({{"id", test.id},
                     {"part", test.part},
                     {"key", test.key},
                     {"share", std::isfinite(test.share) ? test.share : 0},
                     {"message", test.message}});
  for (const JudgedPicture& picture : result.pictures)
    pictures.push_back({{"name", picture.name}, {"title", picture.title}});
  return {{"format", format},
          {"submission", result.submission},
          {"fault", result.fault},
          {"built", result.built},
          {"build_log", result.build_log},
          {"layers", result.layers},
          {"tests", tests},
          {"pictures", pictures}};
}

/// The three of a picture, as files.
std::vector<std::pair<std::string, std::vector<std::uint8_t> JudgedPicture::*>> planes(
    const std::string& name) {
  return {{name + ".fresh.png", &JudgedPicture::fresh},
          {name + ".reference.png", &JudgedPicture::reference},
          {name + ".difference.png", &JudgedPicture::difference}};
}

JudgedPicture read_picture(const fs::path& folder, const std::string& name,
                           const std::string& title) {
  JudgedPicture picture{.name = name, .title = title};
  for (const auto& [file, plane] : planes(name)) {
    const Framebuffer read = read_image(folder / file);
    picture.width = read.width;
    picture.height = read.height;
    picture.*plane = codes_of(read);
  }
  return picture;
}

}  // namespace

void write_result(const fs::path& folder, const Result& result) {
  fs::create_directories(folder);
  fs::remove(folder / result_file);
  for (const JudgedPicture& picture : result.pictures)
    for (const auto& [file, plane] : planes(picture.name))
      write_image(folder / file, picture_of(picture.width, picture.height, picture.*plane));
  write_file(folder / result_file, json_text(to_json(result)));
}

std::optional<Result> read_result(const fs::path& folder) try {
  std::ifstream stream(folder / result_file);
  if (!stream) return std::nullopt;
  const json read = json::parse(stream);
  if (read.at("format") != format) return std::nullopt;
  Result result;
  for (const auto& [key, text] :
       {std::pair{"submission", &result.submission}, std::pair{"fault", &result.fault},
        std::pair{"build_log", &result.build_log}, std::pair{"layers", &result.layers}})
    *text = read.at(key).get<std::string>();
  result.built = read.at("built").get<bool>();
  for (const json& test : read.at("tests"))
    result.tests.push_back({test.at("id"), test.at("part"), test.at("key"), test.at("message"),
                            test.at("share").get<double>()});
  for (const json& picture : read.at("pictures"))
    result.pictures.push_back(read_picture(folder, picture.at("name"), picture.at("title")));
  return result;
} catch (const json::exception&) {
  return std::nullopt;  // of an older version, or damaged: judged again
} catch (const Error&) {
  return std::nullopt;
}

std::string safe_name(const std::string& submission) {
  constexpr std::size_t longest = 100;
  std::string name;
  for (const char c : submission) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ||
                       (c == '.' && !name.empty());
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
    name += plain ? std::string(1, c) : code;
  }
  if (name.size() <= longest) return name;
  return name.substr(0, longest) + "-" + studio::Fingerprint().add(submission).text();
}

Verdict verdict_of(const Result& result, const Rubric& rubric) {
  Verdict verdict{.assignment = rubric.assignment, .seed = rubric.seed};
  verdict.build_log = result.build_log;
  verdict.built = result.built;
  verdict.pictures = result.pictures;
  for (const RubricTest& test : rubric.tests) {
    const auto found = std::ranges::find(result.tests, test.id, &TestResult::id);
    const bool there = found != result.tests.end();
    constexpr double hundredth = 100;
    verdict.tests.push_back(
        {.id = test.id,
         .name = test.name,
         .points = there ? std::round(found->share * test.points * hundredth) / hundredth : 0,
         .max_points = test.points,
         .hidden = test.hidden,
         .message = there ? found->message : result.fault});
  }
  return verdict;
}

}  // namespace scanlit::assignments
