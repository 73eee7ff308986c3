#include "lessons/studio/program.h"

#include <csignal>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

/// File names and words of the user may hold line breaks and control characters: a message stays
/// one line, and no input moves the cursor.
std::string one_line(std::string text) {
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

/// What CLI11 calls "not expected", with what may have been meant.
std::string explain_unexpected(const CLI::App& app) {
  const CLI::App& command = chosen(app);
  const std::string word = app.remaining(true).front();
  const std::string help = "; see " + full_name(command) + " --help";
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
  return kind + " '" + word + "'" + (guess.starts_with("; did") ? guess : help);
}

constexpr int held_signals[] = {SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t held_signal = 0;
extern "C" void remember_signal(int signal_number) { held_signal = signal_number; }

}  // namespace

int run_program(CLI::App& app, int argc, char** argv, const std::function<void()>& action) {
  try {
    try {
      app.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
      throw Error(explain_unexpected(app));
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
      throw Error(error.what());
    }
    action();
    if (!std::cout.flush()) throw Error("cannot write to standard output");
    return 0;
  } catch (const Error& error) {
    return fail(exit_bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(exit_bad_input, "not enough memory");
  } catch (const std::length_error&) {  // a vector asked for more than can be addressed
    return fail(exit_bad_input, "not enough memory");
  } catch (const std::exception& error) {
    return fail(exit_internal, std::string("internal: ") + error.what());
  }
}

HoldInterrupts::HoldInterrupts() {
  for (int signal_number : held_signals) std::signal(signal_number, remember_signal);
}

HoldInterrupts::~HoldInterrupts() {
  for (int signal_number : held_signals) std::signal(signal_number, SIG_DFL);
  if (held_signal != 0) std::raise(held_signal);
}

void warn(const std::string& message) { std::cerr << "warning: " << one_line(message) << '\n'; }

void note(const std::string& message) { std::cerr << "note: " << one_line(message) << '\n'; }

}  // namespace scanlit::studio
