// Another process, whose lines are read while it runs.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace scanlit::bench {

/// Runs `arguments[0]` with the environment of this process and `settings` ("NAME=value") besides;
/// calls `on_line` for every line it prints, as soon as it does. Throws Error where it cannot be
/// started or ends with anything but 0.
void run_process(const std::vector<std::string>& arguments,
                 const std::vector<std::string>& settings,
                 const std::function<void(const std::string&)>& on_line);

/// The running program's file.
std::string this_program();

}  // namespace scanlit::bench
