// Who is in the course, which folder is whose, and how late it was: a CSV file.
//
//   Student,ID,SIS User ID,SIS Login ID,Section,Group,Folder,Late days
//
// The first five are Canvas's own columns: its gradebook's export is a roster, other columns are
// ignored. All but Student may be missing. The submission's folder is called as Folder says, else
// as Group, which several students share, else as SIS Login ID, SIS User ID, ID or Student, the
// first that is not empty.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scanlit::assignments {

struct Student {
  std::string name, id, sis_user_id, sis_login_id, section;  // Canvas's
  std::string folder;
  int late_days = 0;
};

/// Throws Error, with file and row: no column Student, an unnamed student, days that are no whole
/// number 0..365.
std::vector<Student> read_roster(const std::filesystem::path& file);

}  // namespace scanlit::assignments
