// scanlit assignment
#include <iostream>
#include <memory>

#include "lessons/assignments/grade/pack.h"
#include "lessons/assignments/judge/files.h"
#include "lessons/assignments/judge/handout.h"
#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "lessons/studio/table.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

struct NewOptions {
  std::string id, folder, seed = "1";
};

void hand_out_new(const NewOptions& options) {
  const auto& assignment = assignments::assignment(options.id);
  const int seed = parse_integer("--seed", options.seed, {0, 999999});
  const HoldInterrupts until_written;
  assignments::hand_out(assignment, std::uint64_t(seed), options.folder);
  std::cout << options.folder << ": " << assignment.id << ", " << assignment.title << ", variant "
            << seed << "; read README.md, complete " << assignment.file << ", run scanlit check "
            << options.folder << '\n';
}

struct PackOptions {
  std::string id, output = "autograder.zip", rubric, hidden;
};

void pack_autograder(const PackOptions& options) {
  const auto& assignment = assignments::assignment(options.id);
  const HoldInterrupts until_written;
  assignments::pack(assignment, {options.rubric, options.hidden, options.output});
  std::cout << options.output << ": " << assignment.id << " for Gradescope\n";
}

void list() {
  std::vector<std::vector<std::string>> rows;
  for (const auto& assignment : assignments::assignments())
    rows.push_back({assignment.id, assignment.title});
  print_columns(std::cout, rows, "  ");
}

}  // namespace

Command add_assignment_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("assignment",
                                         "Hands out a course assignment, or packs its autograder");
  app->footer(
      "Examples:\n"
      "  scanlit assignment list\n"
      "  scanlit assignment new A1 my-a1 --seed 7\n"
      "  scanlit assignment pack A1 --rubric rubric.toml -o autograder.zip\n"
      "\n"
      "The seed draws the assignment's variant: all of a course get the same, each year another.");
  app->require_subcommand(1);
  CLI::App* all = app->add_subcommand("list", "Lists the assignments");
  CLI::App* fresh = app->add_subcommand("new", "Makes a student's folder");
  const auto options = std::make_shared<NewOptions>();
  fresh->add_option("ASSIGNMENT", options->id, "such as A1")->required();
  fresh->add_option("DIR", options->folder, "a new or empty folder")->required();
  fresh->add_option("--seed", options->seed, "draws the variant (1)")->type_name("N");
  CLI::App* packed = app->add_subcommand("pack", "Makes an autograder for Gradescope");
  const auto packing = std::make_shared<PackOptions>();
  packed->add_option("ASSIGNMENT", packing->id, "such as A1")->required();
  packed->add_option("-o,--output", packing->output, "a zip (autograder.zip)")->type_name("FILE");
  packed->add_option("--rubric", packing->rubric, "(the assignment's)")->type_name("FILE");
  packed->add_option("--hidden", packing->hidden, "tests that students do not see")
      ->type_name("DIR");
  CLI::App* data = app->add_subcommand("data", "Writes the files that an installation holds");
  const auto target = std::make_shared<std::string>(), what = std::make_shared<std::string>();
  data->add_option("WHAT", *what, "course or solutions")
      ->required()
      ->check(CLI::IsMember({"course", "solutions"}));
  data->add_option("DIR", *target, "is made where it is missing")->required();
  return {app, [=] {
            if (all->parsed()) return list();
            if (data->parsed())
              return *what == "course" ? assignments::write_course(*target)
                                       : assignments::write_solutions(*target);
            packed->parsed() ? pack_autograder(*packing) : hand_out_new(*options);
          }};
}

}  // namespace scanlit::studio
