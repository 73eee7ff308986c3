// mutation TREE BUILD [--sample] [--only TEXT] [--resume] [--results FILE]
//
// Plants the faults of tests/mutation/faults one by one in a copy of the source tree, builds there
// what is needed, and runs the tests that should notice. Fails where none does, unless the table
// says why nothing can; where a fault's text no longer stands in its file; where it does not
// compile; and where a test fails without any fault.
//
//   --sample         only the faults marked for it
//   --only TEXT      only those whose file has TEXT in its path
//   --resume         goes on after an interruption: what was caught before is not tried again, as
//                    long as its file is the same
//   --results FILE   writes what was caught by which test, as a table
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>

#include "tests/mutation/faults.h"

namespace {

using namespace scanlit::mutation;

/// Single quotes keep everything from the shell; no path or filter here has one in it.
std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// The mutation build of the copied tree.
struct Build {
  std::string folder;

  bool make(const std::vector<Catcher>& catchers, const std::string& log) const {
    std::string command = "ninja -C " + quoted(folder);
    for (const Catcher& c : catchers) command += " mutation_" + c.program;
    return std::system((command + " >" + quoted(log) + " 2>&1").c_str()) == 0;
  }

  /// The first test of the program that fails, or what else went wrong; empty: all pass.
  std::string failure(const Catcher& c) const {
    const std::string log = folder + "/mutation.log";
    // A fault may make a loop endless; seconds of the processor's time.
    const std::string program = folder + "/tests/mutation/mutation_" + c.program;
    const std::string command =
        "ulimit -t 120; " + quoted(program) +
        " --gtest_brief=1 --gtest_fail_fast --gtest_filter=" + quoted(c.filter) + " >" +
        quoted(log) + " 2>&1";
    const int status = std::system(command.c_str());
    if (status == 0) return "";
    std::ifstream in(log);
    const std::string mark = "[  FAILED  ] ";
    for (std::string line; std::getline(in, line);)
      if (line.starts_with(mark) && line.find('.') != line.npos)
        return line.substr(mark.size(), line.find_first_of(", (", mark.size()) - mark.size());
    return c.program + " (it crashes, or does not end)";
  }
};

/// What became of a fault: the test that noticed; empty: it survived.
struct Outcome {
  const Fault* fault;
  std::string caught_by, problem;
};

/// What was caught in earlier runs, and by which test: a line "KEY TEST" each.
class Memory {
 public:
  Memory(const Build& build, const std::string& tree)
      : file_(build.folder + "/caught"), tree_(tree) {}

  void load() {
    std::ifstream in(file_);
    for (std::string key, test; in >> key && std::getline(in, test);) caught_[key] = test.substr(1);
  }
  std::string caught_by(const Fault& fault) const {
    const auto found = caught_.find(key(fault));
    return found == caught_.end() ? "" : found->second;
  }
  void keep(const Outcome& o) const {
    if (o.problem.empty() && !o.caught_by.empty())
      std::ofstream(file_, std::ios::app) << key(*o.fault) << ' ' << o.caught_by << '\n';
  }

 private:
  std::string key(const Fault& fault) const {
    return std::to_string(std::hash<std::string>()(fault.file.string() + with_fault(fault, tree_)));
  }

  std::string file_, tree_;
  std::map<std::string, std::string> caught_;
};

Outcome try_out(const Fault& fault, const std::string& tree, const Build& build) {
  Outcome outcome{&fault, "", ""};
  try {
    const Planted planted(fault, tree);
    for (const Catcher& c : fault.catchers) {
      if (!build.make({c}, build.folder + "/build.log")) {
        outcome.problem = "it does not compile";
        break;
      }
      outcome.caught_by = build.failure(c);
      if (!outcome.caught_by.empty()) break;
    }
  } catch (const std::exception& error) {
    outcome.problem = error.what();
  }
  if (outcome.problem.empty() && outcome.caught_by.empty() && fault.equivalent.empty())
    outcome.problem = "it survives";
  if (!outcome.caught_by.empty() && !fault.equivalent.empty())
    outcome.problem = "it is caught, though the table says it cannot be";
  return outcome;
}

/// In a table's cell, as code.
std::string code(const std::string& text) {
  std::string result = "`";
  for (const char c : text) result += c == '|' ? "\\|" : std::string(1, c);
  return result + "`";
}

void write_results(const std::string& file, const std::vector<Outcome>& outcomes) {
  std::ofstream out(file);
  std::map<std::string, int> kinds;
  std::set<std::filesystem::path> files;
  int caught = 0;
  for (const Outcome& o : outcomes) {
    ++kinds[o.fault->kind], files.insert(o.fault->file);
    caught += !o.caught_by.empty();
  }
  out << "<!-- Written by tests/mutation/run --long. -->\n"
      << outcomes.size() << " faults in " << files.size() << " files: " << caught << " caught, "
      << outcomes.size() - std::size_t(caught) << " not.\n\n| kind | faults |\n|---|---|\n";
  for (const auto& [kind, count] : kinds) out << "| " << kind << " | " << count << " |\n";
  out << "\n| file | what it stands for | in place of | stands | caught by |\n"
         "|---|---|---|---|---|\n";
  for (const auto& [fault, caught_by, problem] : outcomes)
    out << "| " << fault->file.string() << " | " << fault->meaning << " | " << code(fault->original)
        << " | " << code(fault->replacement) << " | "
        << (!problem.empty()    ? "**" + problem + "**"
            : caught_by.empty() ? "none: " + fault->equivalent
                                : caught_by)
        << " |\n";
  if (!out.flush()) throw std::runtime_error(file + " cannot be written");
}

/// Every test that the faults want passes as long as there is none.
bool sound(const std::vector<const Fault*>& faults, const Build& build) {
  std::map<std::string, std::set<std::string>> filters;
  for (const Fault* fault : faults)
    for (const Catcher& c : fault->catchers) filters[c.program].insert(c.filter);
  std::vector<Catcher> all;
  for (const auto& [program, wanted] : filters)
    for (const std::string& filter : wanted) all.push_back({program, filter});
  const std::string log = build.folder + "/build.log";
  if (!build.make(all, log)) {
    std::cerr << std::ifstream(log).rdbuf() << "error: the tree does not build\n";
    return false;
  }
  for (const Catcher& c : all)
    if (const std::string failed = build.failure(c); !failed.empty()) {
      std::cerr << "error: " << failed << " fails without any fault\n";
      return false;
    }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::cerr << "error: mutation TREE BUILD [options]\n", 2;
  const std::string tree = argv[1];
  const Build build{argv[2]};
  Memory memory(build, tree);
  bool sample = false;
  std::string only, results;
  for (int i = 3; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--sample")
      sample = true;
    else if (option == "--resume")
      memory.load();
    else if (option == "--only" && i + 1 < argc)
      only = argv[++i];
    else if (option == "--results" && i + 1 < argc)
      results = argv[++i];
    else
      return std::cerr << "error: unknown option " << option << '\n', 2;
  }
  try {
    const std::vector<Fault> all = read_faults(tree + "/tests/mutation/faults");
    std::vector<const Fault*> wanted;
    bool failed = false;
    for (const Fault& fault : all) {
      if ((!sample || fault.in_sample) && fault.file.string().find(only) != std::string::npos)
        wanted.push_back(&fault);
      try {
        with_fault(fault, tree);
      } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        failed = true;
      }
    }
    if (failed) return 1;
    std::vector<const Fault*> untried = wanted;
    std::erase_if(untried, [&](const Fault* f) { return !memory.caught_by(*f).empty(); });
    if (!sound(untried, build)) return 1;
    std::vector<Outcome> outcomes;
    for (const Fault* fault : wanted) {
      const std::string before = memory.caught_by(*fault);
      const Outcome& o = outcomes.emplace_back(before.empty() ? try_out(*fault, tree, build)
                                                              : Outcome{fault, before, ""});
      if (before.empty()) memory.keep(o);
      failed |= !o.problem.empty();
      std::cout << (o.problem.empty() ? "ok    " : "FAIL  ") << fault->file.string() << ": "
                << fault->meaning << "\n      "
                << (!o.problem.empty()    ? o.problem
                    : o.caught_by.empty() ? "survives: " + fault->equivalent
                                          : o.caught_by)
                << std::endl;
    }
    std::cout << wanted.size() << " of " << all.size() << " faults tried, all of them apply\n";
    if (!results.empty()) write_results(results, outcomes);
    return failed;
  } catch (const std::exception& error) {
    return std::cerr << "error: " << error.what() << '\n', 1;
  }
}
