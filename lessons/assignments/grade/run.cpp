#include "lessons/assignments/grade/run.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "lessons/assignments/grade/json_text.h"
#include "lessons/assignments/grade/leaderboard.h"
#include "lessons/assignments/grade/write_file.h"
#include "lessons/assignments/grade/writers.h"
#include "lessons/assignments/judge/report.h"
#include "lessons/studio/fingerprint.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {
namespace fs = std::filesystem;
namespace {

/// One submission, from its folder to its result.
struct Task {
  fs::path submission;
  std::string name;
  std::string key;  // of submission and package
  Result standing;  // what need not be judged again
  std::vector<RubricTest> missing;
};

class Grading {
 public:
  explicit Grading(const GradeJob& job)
      : job_(job), assignment_(assignment(job.rubric.assignment)) {
    const std::string package = package_key(assignment_, job.rubric.seed);
    for (const fs::path& submission : job.submissions) {
      Task task{submission, name_of(submission), {}, {}, {}};
      task.key =
          studio::Fingerprint().add(package).add(submission_key(submission, assignment_)).text();
      const Result earlier = read_result(folder(task)).value_or(Result{});
      task.standing = standing(earlier, job.rubric, task.key, task.missing);
      task.standing.submission = task.name;
      tasks_.push_back(std::move(task));
    }
    std::ranges::sort(tasks_, {}, &Task::name);
  }

  GradeRun run() {
    GradeRun result;
    std::vector<const Task*> open;
    for (const Task& task : tasks_) (task.missing.empty() ? result.kept : result.judged)++;
    for (const Task& task : tasks_)
      if (!task.missing.empty()) open.push_back(&task);
    judge_all(open);
    for (const Task& task : tasks_) {
      result.grades.push_back(publish(task.missing.empty()
                                          ? task.standing
                                          : read_result(folder(task)).value_or(faulty(task, ""))));
    }
    add_absent(result.grades);
    return result;
  }

 private:
  static std::string name_of(const fs::path& submission) {
    return fs::absolute(submission).lexically_normal().filename().empty()
               ? fs::absolute(submission).lexically_normal().parent_path().filename().string()
               : fs::absolute(submission).lexically_normal().filename().string();
  }
  fs::path folder(const Task& task) const { return job_.results / safe_name(task.name); }

  static Result faulty(const Task& task, const std::string& why) {
    Result result;
    result.submission = task.name;
    result.fault = why.empty() ? "the judge ended without a result" : why;
    return result;
  }

  /// As many at a time as there are jobs, each in a child.
  void judge_all(const std::vector<const Task*>& open) {
    std::map<pid_t, const Task*> running;
    std::size_t next = 0, done = 0;
    while (next < open.size() || !running.empty()) {
      if (next < open.size() && int(running.size()) < job_.jobs) {
        const pid_t child = fork();
        if (child == 0) judge_and_exit(*open[next]);
        if (child < 0) throw Error("fork", "no process more can be made");
        running[child] = open[next++];
        continue;
      }
      int status = 0;
      const pid_t child = waitpid(-1, &status, 0);
      const auto place = running.find(child);
      if (place == running.end()) continue;
      if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) note_fault(*place->second, status);
      running.erase(place);
      if (job_.progress) job_.progress(double(++done) / double(open.size()));
    }
  }

  /// The child wrote a result with its own words, unless it died of what it judged.
  void note_fault(const Task& task, int status) const {
    if (WIFSIGNALED(status))
      write_result(folder(task), faulty(task, "the judge crashed with signal " +
                                                  std::to_string(WTERMSIG(status))));
  }

  [[noreturn]] void judge_and_exit(const Task& task) const {
    // Without a parent nobody wants the result; what has become whole by then is kept.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    int code = 0;
    try {
      const Result result = judge_one(task);
      write_result(folder(task), result);
      publish(result);
    } catch (const std::exception& error) {
      code = 1;
      try {
        write_result(folder(task), faulty(task, error.what()));
      } catch (const std::exception&) {  // a full disk: there is no result then
      }
    }
    _exit(code);
  }

  Result judge_one(const Task& task) const {
    Rubric rubric = job_.rubric;
    rubric.tests = task.missing;
    for (RubricTest& test : rubric.tests) test.points = 1;  // shares
    const JudgeOptions options{
        .scratch = fs::temp_directory_path(),
        .build_limits = {.cpu_seconds = 30, .memory_bytes = 1 << 30, .processes = 16},
        .limits = {.cpu_seconds = 5, .wall_seconds = 20, .processes = 1},
        .layers = job_.layers};
    const Verdict verdict = judge(assignment_, task.submission, rubric, options);
    Result result = task.standing;
    result.built = verdict.built;
    result.build_log = verdict.build_log;
    result.layers = sandbox::in_force(job_.layers);
    nlohmann::json seconds;
    for (const TestScore& test : verdict.tests) {
      const auto place = std::ranges::find(result.tests, test.id, &TestResult::id);
      place->share = test.points;
      place->message = test.message;
      seconds[test.id] = test.seconds;
    }
    if (verdict.effort) seconds["effort"] = effort_json(*verdict.effort);
    for (const JudgedPicture& picture : verdict.pictures) {
      std::erase_if(result.pictures, [&](const auto& old) { return old.name == picture.name; });
      result.pictures.push_back(picture);
    }
    fs::create_directories(folder(task));
    write_file(folder(task) / "times.json", json_text(seconds));
    return result;
  }

  Grade publish(const Result& result) const {
    const auto marks = job_.marks.find(result.submission);
    std::vector<Student> students;
    for (const Student& student : job_.roster)
      if (student.folder == result.submission) students.push_back(student);
    if (job_.roster.empty())
      students.push_back({.name = result.submission,
                          .id = "",
                          .sis_user_id = "",
                          .sis_login_id = result.submission,
                          .section = "",
                          .folder = result.submission});
    int late_days = 0;
    for (const Student& student : students) late_days = std::max(late_days, student.late_days);
    Grade grade =
        score(result, job_.rubric, marks == job_.marks.end() ? Marks{} : marks->second, late_days);
    grade.students = std::move(students);
    const fs::path folder = job_.results / grade.folder;
    fs::create_directories(folder);
    write_file(folder / "results.json", gradescope_results(grade, result.build_log));
    Verdict verdict = verdict_of(result, job_.rubric);
    for (TestScore& test : verdict.tests)
      for (const ScoredPart& part : grade.parts)
        if (part.id == test.id) test.points = part.points;
    write_file(folder / "report.html", report_page(assignment_, verdict));
    return grade;
  }

  void add_absent(std::vector<Grade>& grades) const {
    std::map<std::string, std::vector<Student>> absent;
    for (const Student& student : job_.roster)
      if (std::ranges::find(tasks_, student.folder, &Task::name) == tasks_.end())
        absent[student.folder].push_back(student);
    for (const auto& [folder, students] : absent) {
      Result nothing;
      nothing.submission = folder;
      const auto marks = job_.marks.find(folder);
      Grade grade =
          score(nothing, job_.rubric, marks == job_.marks.end() ? Marks{} : marks->second, 0);
      grade.handed_in = false;
      grade.students = students;
      grades.push_back(std::move(grade));
    }
  }

  const GradeJob& job_;
  const Assignment& assignment_;
  std::vector<Task> tasks_;
};

}  // namespace

GradeRun run_grading(const GradeJob& job) { return Grading(job).run(); }

std::vector<std::string> oddities(const GradeJob& job, const GradeRun& run) {
  std::vector<std::string> found;
  const std::string& file = assignment(job.rubric.assignment).file;
  for (const fs::path& submission : job.submissions)
    if (!fs::exists(submission / file))
      found.push_back(submission.filename().string() + " has no " + file);
  for (const Grade& grade : run.grades)
    if (grade.students.empty())
      found.push_back(grade.submission + " is in no row of the roster, and so not in grades.csv");
  for (const auto& [name, marks] : job.marks)
    if (std::ranges::find(run.grades, name, &Grade::submission) == run.grades.end())
      found.push_back("the marks of '" + name + "' are nobody's: there is no such submission");
  return found;
}

}  // namespace scanlit::assignments
