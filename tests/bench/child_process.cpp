#include "child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "rasterizer/error.h"

extern char** environ;

namespace scanlit::bench {

namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment_with(const std::vector<std::string>& settings) {
  std::vector<std::string> all = settings;  // the first of two of the same name counts
  for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
  return all;
}

}  // namespace

void run_process(const std::vector<std::string>& arguments,
                 const std::vector<std::string>& settings,
                 const std::function<void(const std::string&)>& on_line) {
  std::vector<std::string> argument_texts = arguments, environment = environment_with(settings);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(arguments[0], std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  pid_t process = 0;
  const int failure = posix_spawn(&process, arguments[0].c_str(), &actions, nullptr,
                                  pointers(argument_texts).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::FILE* const output = fdopen(ends[0], "r");
  if (failure == 0)
    for (char line[8192]; std::fgets(line, sizeof line, output);) on_line(line);
  std::fclose(output);
  if (failure != 0) throw Error(arguments[0], std::strerror(failure));

  int status = 0;
  waitpid(process, &status, 0);
  if (status != 0) throw Error(arguments[0], "ended before its work was done");
}

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace scanlit::bench
