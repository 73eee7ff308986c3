// scanlit grade
#include <sys/stat.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <set>
#include <thread>

#include "lessons/assignments/grade/leaderboard.h"
#include "lessons/assignments/grade/run.h"
#include "lessons/assignments/grade/write_file.h"
#include "lessons/assignments/grade/writers.h"
#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "lessons/studio/progress_bar.h"
#include "lessons/studio/text.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

namespace fs = std::filesystem;
using namespace assignments;

struct GradeOptions {
  std::vector<std::string> submissions;
  std::string rubric, hidden, roster, marks, jobs, output = "results";
};

std::vector<fs::path> folders_of(const GradeOptions& options) {
  std::vector<fs::path> folders;
  std::set<std::string> names;
  for (const std::string& name : options.submissions) {
    fs::path folder = fs::absolute(name).lexically_normal();
    if (folder.filename().empty()) folder = folder.parent_path();
    if (!fs::is_directory(folder)) {
      warn(name + " is no folder, and no submission");
      continue;
    }
    if (!names.insert(folder.filename().string()).second)
      throw Error(name, "there is a submission of this name already");
    folders.push_back(folder);
  }
  if (folders.empty()) throw Error("there are no submissions");
  return folders;
}

/// Hidden tests are as hidden as what a submission can read.
void check_hidden(const std::string& folder, const sandbox::Layers& layers) {
  struct stat status;
  if (stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    throw Error("--hidden", folder + " is not a folder");
  if (!layers.uid)
    throw Error("--hidden",
                "no user of its own can be given to a submission here, which could then read the "
                "hidden tests: grade as root, or without them");
  constexpr mode_t others = 077;
  if ((status.st_mode & others) != 0)
    throw Error("--hidden", folder + " can be read by others: chmod 700 it first");
}

std::vector<std::string> about(const GradeRun& run, const sandbox::Layers& layers) {
  std::vector<std::string> lines{std::to_string(run.grades.size()) + " submissions",
                                 "in force while judging: " + sandbox::in_force(layers)};
  for (const std::string& layer : sandbox::not_in_force(layers))
    lines.push_back("not in force: " + layer);
  return lines;
}

void report_faults(const GradeRun& run) {
  std::string first;
  int count = 0;
  for (const Grade& grade : run.grades) {
    if (grade.fault.empty()) continue;
    if (++count == 1) first = grade.submission + ": " + grade.fault;
  }
  if (count > 0)
    throw Error(std::to_string(count) +
                " of the submissions could not be judged, all others are; " + first);
}

void write_all(const fs::path& results, const Assignment& assignment, const GradeRun& run,
               const sandbox::Layers& layers) {
  const std::string title = assignment.id + " " + assignment.title;
  write_file(results / "grades.csv", class_csv(title, run.grades));
  write_file(results / "parts.csv", parts_csv(run.grades));
  write_file(results / "junit.xml", junit_xml(title, run.grades));
  write_file(results / "index.html", overview_page(title, run.grades, about(run, layers)));
  if (assignment.effort)
    write_file(results / "leaderboard.csv", leaderboard_csv(results, run.grades));
}

void grade(const GradeOptions& options) {
  GradeJob job;
  job.submissions = folders_of(options);
  job.rubric = read_rubric(options.rubric);
  job.layers = sandbox::available();
  if (!options.hidden.empty()) {
    check_hidden(options.hidden, job.layers);
    add_hidden_tests(options.hidden, job.rubric);
  }
  if (!options.roster.empty()) job.roster = read_roster(options.roster);
  job.jobs = options.jobs.empty() ? int(std::max(1u, std::thread::hardware_concurrency()))
                                  : parse_integer("--jobs", options.jobs, {1, 256});
  job.results = options.output;
  fs::create_directories(job.results);
  fs::permissions(job.results, fs::perms::owner_all);  // no submission reads the others' results
  const fs::path marks =
      options.marks.empty() ? job.results / "marks.toml" : fs::path(options.marks);
  if (options.marks.empty()) write_empty_marks(marks, job.rubric);
  job.marks = read_marks(marks, job.rubric);
  if (!job.layers.uid) warn("submissions run as your own user; as root each gets one of its own");
  sandbox::remove_abandoned(fs::temp_directory_path());

  GradeRun run;
  {
    ProgressBar bar("grading");
    job.progress = [&](double share) { bar.show(share); };
    run = run_grading(job);
  }
  write_all(job.results, assignments::assignment(job.rubric.assignment), run, job.layers);
  std::cout << options.output << ": " << run.judged << " judged, " << run.kept
            << " as before; behind " << sandbox::in_force(job.layers) << '\n';
  for (const std::string& oddity : oddities(job, run)) warn(oddity);
  report_faults(run);
}

}  // namespace

Command add_grade_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("grade", "Grades submissions of an assignment");
  app->footer(
      "Examples:\n"
      "  scanlit grade submissions/* --rubric rubric.toml --roster roster.csv -o results\n"
      "  scanlit grade submissions/* --rubric rubric.toml --hidden hidden -o results\n"
      "\n"
      "RESULTS/index.html shows all; grades.csv is for Canvas and Moodle, junit.xml for others,\n"
      "and in each submission's folder results.json for Gradescope. Points by hand go into\n"
      "RESULTS/marks.toml. Repeated, the command judges what has changed since.");
  const auto options = std::make_shared<GradeOptions>();
  app->add_option("DIR", options->submissions, "submissions, a folder each")->required();
  app->add_option("--rubric", options->rubric, "tests and points, late days")
      ->required()
      ->type_name("FILE");
  app->add_option("--hidden", options->hidden, "tests that students do not see")->type_name("DIR");
  app->add_option("--roster", options->roster, "students, groups, late days")->type_name("CSV");
  app->add_option("--marks", options->marks, "points by hand (RESULTS/marks.toml)")
      ->type_name("FILE");
  app->add_option("--jobs", options->jobs, "submissions at a time (one per processor)")
      ->type_name("N");
  app->add_option("-o,--output", options->output, "folder of results (results)")
      ->type_name("RESULTS");
  return {app, [options] { grade(*options); }};
}

}  // namespace scanlit::studio
