#include "lessons/studio/program.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

/// File names and words of the user may hold line breaks and control characters, and be as long as
/// a file: a message stays one line that can be read, and no input moves the cursor.
std::string one_line(std::string text) {
  constexpr std::size_t longest = 1000, kept = 400;  // at either end
  if (text.size() > longest) text.replace(kept, text.size() - 2 * kept, " ... ");
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

int fail(int exit_code, const std::string& message) {
  std::cerr << "error: " << one_line(message) << '\n';
  return exit_code;
}

/// The command that the command line named, or the program itself.
const CLI::App& chosen(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

std::string full_name(const CLI::App& app) {
  return (app.get_parent() ? full_name(*app.get_parent()) + " " : "") + app.get_name();
}

std::string see_help(const CLI::App& app) { return "; see " + full_name(app) + " --help"; }

/// What CLI11 calls "not expected", with what may have been meant.
std::string explain_unexpected(const CLI::App& app) {
  const CLI::App& command = chosen(app);
  const std::string word = app.remaining(true).front();
  std::vector<std::string> candidates;
  std::string kind = "unexpected argument";
  if (word.starts_with("-")) {
    kind = "unknown option";
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) candidates.push_back("--" + name);
  } else if (&command == &app) {
    kind = "unknown command";
    for (const CLI::App* sub : app.get_subcommands({})) candidates.push_back(sub->get_name());
  }
  const std::string guess =
      candidates.empty() ? "" : did_you_mean(word.substr(0, word.find('=')), candidates);
  // A list of all options is no help in one line.
  return kind + " '" + word + "'" + (guess.starts_with("; did") ? guess : see_help(command));
}

volatile std::sig_atomic_t held_signal = 0;
extern "C" void remember_signal(int signal_number) { held_signal = signal_number; }

/// Whether there is something to do; else help or the version was asked for, and printed.
bool read_command_line(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::CallForHelp&) {
    std::cout << CLI::detail::find_and_replace(app.help(), "\n\n\n", "\n\n");
  } catch (const CLI::Success& version) {
    std::cout << version.what() << '\n';
  } catch (const CLI::ExtrasError&) {
    throw Error(explain_unexpected(app));
  } catch (const CLI::ParseError& error) {
    throw Error(error.what() + see_help(chosen(app)));
  }
  return false;
}

}  // namespace

int run_program(const std::string& name, int argc, char** argv, const Setup& setup) {
  // Beyond `ulimit -f` a write fails then, as on a full disk, and does not end the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    CLI::App app("", name);
    const std::function<void()> action = setup(app);
    if (read_command_line(app, argc, argv)) action();
    if (!std::cout.flush()) throw Error("cannot write to standard output");
    return 0;
  } catch (const Error& error) {
    return fail(exit_bad_input, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(exit_bad_input, error.path1().string() + ": " + error.code().message());
  } catch (const std::bad_alloc&) {
    return fail(exit_bad_input, "not enough memory");
  } catch (const std::length_error&) {  // a vector asked for more than can be addressed
    return fail(exit_bad_input, "not enough memory");
  } catch (const std::exception& error) {
    return fail(exit_internal, std::string("internal: ") + error.what());
  }
}

HoldInterrupts::HoldInterrupts() {
  for (std::size_t i = 0; i < held_signals.size(); ++i)
    before_[i] = std::signal(held_signals[i], remember_signal);
}

HoldInterrupts::~HoldInterrupts() {
  for (std::size_t i = 0; i < held_signals.size(); ++i) std::signal(held_signals[i], before_[i]);
  if (held_signal != 0) std::raise(held_signal);
}

void warn(const std::string& message) { std::cerr << "warning: " << one_line(message) << '\n'; }

void note(const std::string& message) { std::cerr << "note: " << one_line(message) << '\n'; }

}  // namespace scanlit::studio
