// Where an assignment's files are, and what is made of them for a student.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/assignments/judge/assignment.h"

namespace scanlit::assignments {

/// The folder that holds the assignments' folders and answer/: ../share/scanlit/assignments beside
/// the program, or, in a build tree, the source's. Throws Error where there is neither.
std::filesystem::path data_folder();

/// A file as a student or a compiler gets it.
struct Made {
  std::string name;  // in the folder it is for
  std::string text;
};

/// What the student's file is compiled with: the assignment's header, main.cpp, variant.h and
/// answer/.
std::vector<Made> support_files(const Assignment& assignment, std::uint64_t seed);

/// The file that the student is to complete. Installed for students it is there as it is
/// (starter.cpp or .h); in the source it is the solution, stripped.
Made starter(const Assignment& assignment);

/// Throws Error where the solutions are not installed.
Made solution(const Assignment& assignment);

/// Writes the data folder of students: all but solutions, and what would give them away.
void write_course(const std::filesystem::path& folder);
/// What instructors have beside: solutions and wrong solutions.
void write_solutions(const std::filesystem::path& folder);

}  // namespace scanlit::assignments
