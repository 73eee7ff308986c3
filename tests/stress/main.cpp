// stress_tests [--seconds-each S] [--case N] [--table FILE] [GoogleTest's options]
//
//   --seconds-each S   search for so long for each property; without it, for some fixed number of
//                      cases, all of them in less than a minute
//   --case N           only this case, of the property that --gtest_filter names
//   --table FILE       writes what was tried and the worst that was found as a table
// stress_tests --pictures FILE        draws random scenes into a file
// stress_tests --compare FILE FILE    compares two of them, of builds for other vectors
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string_view>

#include "tests/stress/levels.h"
#include "tests/stress/property.h"

namespace {

using namespace scanlit::stress;

[[noreturn]] void refuse(const std::string& what) {
  std::cerr << "error: " << what << '\n';
  std::exit(2);
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

void write_table(const std::string& file) {
  std::ofstream out(file);
  out << "| property | holds for | cases | checks | worst found |\n|---|---|---|---|---|\n";
  for (const Finding& f : findings()) {
    out << "| " << f.test << ": " << f.statement << " | " << f.range << " | " << f.cases << " | "
        << number(double(f.checks)) << " | " << (f.failed ? "**FAILED** " : "") << number(f.worst)
        << ' ' << f.unit;
    if (f.worst > 0) out << " (case " << f.worst_case << ": " << f.worst_inputs << ")";
    out << " |\n";
  }
  if (!out.flush()) refuse("cannot write " + file);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const std::string command = argc > 1 ? argv[1] : "";
  try {
    if (command == "--pictures" && argc == 3) return write_pictures(argv[2], 60), 0;
    if (command == "--compare" && argc == 4) return !pictures_agree(argv[2], argv[3]);
  } catch (const std::exception& error) {
    refuse(error.what());
  }
  std::string table;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view option = argv[i];
    if (i + 1 == argc) refuse("unknown option or no value: " + std::string(option));
    const std::string value = argv[i + 1];
    if (option == "--seconds-each")
      effort().seconds_each = std::atof(value.c_str());
    else if (option == "--case")
      effort().only_case = std::atoll(value.c_str());
    else if (option == "--table")
      table = value;
    else
      refuse("unknown option " + std::string(option));
  }
  const int result = RUN_ALL_TESTS();
  if (!table.empty()) write_table(table);
  return result;
}
