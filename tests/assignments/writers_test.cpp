// What is written about submissions, with text in it that was written to attack its readers.
#include "lessons/assignments/grade/writers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "lessons/assignments/grade/csv.h"
#include "lessons/assignments/grade/json_text.h"
#include "lessons/studio/pages/page.h"

namespace scanlit::assignments {
namespace {

using nlohmann::json;

/// Script, an escape sequence that clears a terminal, what XML cannot hold, broken UTF-8.
const std::string evil = "<script>alert(1)</script>\x1b[2J\x01]]>\xff\xc2\x9b\xef\xbf\xbf&amp;\"'";

Grade hostile_grade() {
  Grade grade;
  grade.submission = evil;
  grade.folder = safe_name(evil);
  grade.parts = {
      {.id = "A1.1", .name = evil, .message = evil, .points = 5, .max_points = 10},
      {.id = "H", .name = "Hidden", .message = "a secret", .max_points = 10, .hidden = true},
      {.id = "M", .name = "By hand", .max_points = 5, .manual = true}};
  grade.points = 5;
  grade.total = 4.5;
  grade.max_points = 25;
  grade.comment = evil;
  grade.students = {{.name = "=HYPERLINK(\"http://x\",\"me\")",
                     .id = "7",
                     .sis_user_id = "+1",
                     .sis_login_id = "@SUM(A1)",
                     .section = "a\nb",
                     .folder = evil}};
  return grade;
}

bool has_control_characters(const std::string& text) {
  for (const char c : text)
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r') || c == 0x7f)
      return true;
  return false;
}

/// As much of JSON Schema as gradescope_results.schema.json uses.
void expect_valid(const json& value, const json& rule, const json& schema, const std::string& at) {
  if (rule.contains("$ref")) {
    const std::string name = rule["$ref"];
    return expect_valid(value, schema["$defs"][name.substr(name.rfind('/') + 1)], schema, at);
  }
  if (rule.contains("enum")) {
    EXPECT_TRUE(std::ranges::find(rule["enum"], value) != rule["enum"].end()) << at;
  }
  const json type = rule.value("type", json());
  if (type == "object") {
    ASSERT_TRUE(value.is_object()) << at;
    for (const auto& key : rule.value("required", json::array()))
      EXPECT_TRUE(value.contains(key)) << at << "." << key;
    for (const auto& [key, member] : value.items()) {
      ASSERT_TRUE(rule["properties"].contains(key)) << at << "." << key;
      expect_valid(member, rule["properties"][key], schema, at + "." + key);
    }
  } else if (type == "array") {
    ASSERT_TRUE(value.is_array()) << at;
    for (const json& element : value) expect_valid(element, rule["items"], schema, at + "[]");
  } else if (type == "string") {
    EXPECT_TRUE(value.is_string()) << at;
  } else if (type == "number") {
    EXPECT_TRUE(value.is_number()) << at;
  }
}

TEST(Gradescope, ResultsAreWhatTheSchemaSays) {
  const json schema = json::parse(studio::read_text(
      SCANLIT_SOURCE_DIR "/lessons/assignments/grade/gradescope_results.schema.json"));
  Grade grade = hostile_grade();
  grade.parts[0].points = std::numeric_limits<double>::quiet_NaN();
  for (const bool built : {true, false}) {
    grade.built = built;
    const std::string text = gradescope_results(grade, evil);
    EXPECT_FALSE(has_control_characters(text));
    const json results = json::parse(text);
    expect_valid(results, schema, schema, "results");
    EXPECT_FALSE(results.contains("score"));  // or a rubric in Gradescope would be overridden
    EXPECT_EQ(results["tests"][0]["score"], 0);
  }
}

TEST(Gradescope, OfHiddenTestsNameAndPointsAlone) {
  const std::string text = gradescope_results(hostile_grade(), "");
  EXPECT_EQ(text.find("secret"), text.npos);
  const json hidden = json::parse(text)["tests"][1];
  EXPECT_EQ(hidden["name"], "Hidden");
  EXPECT_EQ(hidden["max_score"], 10);
  EXPECT_FALSE(hidden.contains("output"));
}

TEST(JUnit, HoldsOnlyWhatXmlCan) {
  const std::string text = junit_xml(evil, {hostile_grade()});
  EXPECT_FALSE(has_control_characters(text));
  EXPECT_EQ(text.find("<script"), text.npos);
  EXPECT_EQ(text.find("\xff"), text.npos);
  EXPECT_EQ(text.find("\xef\xbf\xbf"), text.npos);
  EXPECT_EQ(text.find("]]>"), text.npos);
  EXPECT_NE(text.find("tests=\"3\" failures=\"2\" errors=\"0\" skipped=\"1\""), text.npos) << text;
}

TEST(ClassCsv, HasCanvasColumnsAndNoFormulas) {
  const std::string text = class_csv("A1", {hostile_grade()});
  const auto rows = read_csv("text", text);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], (CsvRow{"Student", "ID", "SIS User ID", "SIS Login ID", "Section", "A1"}));
  EXPECT_EQ(rows[1].back(), "25");
  EXPECT_EQ(rows[2],
            (CsvRow{"'=HYPERLINK(\"http://x\",\"me\")", "7", "'+1", "'@SUM(A1)", "a b", "4.5"}));
}

TEST(PartsCsv, IsOneRowASubmission) {
  Grade grade = hostile_grade();
  grade.parts[0].points = std::numeric_limits<double>::infinity();
  const auto rows = read_csv("text", parts_csv({grade, grade}));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].size(), rows[1].size());
  EXPECT_EQ(rows[1][1], "0");
}

TEST(Csv, ReadsWhatItWrites) {
  for (const std::string text : {"", "a", "a,b", "say \"hi\"", "  two", "'", "\xc3\xa9"})
    EXPECT_EQ(read_csv("text", csv_line({csv_text(text), "1"}))[0], (CsvRow{text, "1"}));
  EXPECT_EQ(csv_text("-1+cmd|' /C calc'!A0"), "\"'-1+cmd|' /C calc'!A0\"");
  EXPECT_EQ(read_csv("x",
                     "\xef\xbb\xbf"
                     "a,b\r\n\r\n1,\"2\n3\"\n"),
            (std::vector<CsvRow>{{"a", "b"}, {"1", "2\n3"}}));
  EXPECT_THROW(read_csv("x", "a,\"b"), Error);
  EXPECT_THROW(read_csv("x", std::string_view("a\0b", 3)), Error);
}

TEST(OverviewPage, RunsNoScript) {
  Grade grade = hostile_grade();
  grade.picture = grade.folder + "/a.png";
  const std::string text = overview_page(evil, {grade}, {evil});
  EXPECT_FALSE(has_control_characters(text));
  EXPECT_EQ(text.find("<script"), text.npos);
  EXPECT_NE(text.find("default-src 'none'"), text.npos);
}

TEST(SafeName, IsAFilesNameAndTellsSubmissionsApart) {
  EXPECT_EQ(safe_name("alice_2"), "alice_2");
  EXPECT_EQ(safe_name("a/../b\n\"\xf0\x9f\x98\x80"), "a%2F..%2Fb%0A%22%F0%9F%98%80");
  EXPECT_EQ(safe_name(".."), "%2E.");
  EXPECT_LE(safe_name(std::string(255, '\n')).size(), 120u);
  EXPECT_NE(safe_name(std::string(255, 'a')), safe_name(std::string(254, 'a')));
}

}  // namespace
}  // namespace scanlit::assignments
