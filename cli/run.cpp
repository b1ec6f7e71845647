// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string_view>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/printing.h"
#include "cli/run_limits.h"
#include "cli/terminal.h"
#include "cli/version_text.h"
#include "kinematics/catalogue.h"

namespace camlaw::cli {
namespace {

/// One line on standard error.
int complain(std::string message, int status) {
  warn(std::move(message));
  return status;
}

/// Standard streams that are closed stay so for all that is printed, and the files that the program
/// opens do not take their numbers.
void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // Opened the wrong way round, so that reading or writing fails as it should.
    open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

/// What to say of an unknown word: the commands that are near.
std::string with_near_commands(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  const auto near = near_names(word, known);
  return fmt::format("no command '{}'; {}", word,
                     near.empty() ? fmt::format("there are {}", fmt::join(known, ", "))
                                  : fmt::format("did you mean {}?", fmt::join(near, ", ")));
}

int usage_error(const CLI::App& app, const CLI::ParseError& error, int argc,
                const char* const* argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (app.get_subcommands().empty() && !word.empty() && word.front() != '-') {
    return complain(with_near_commands(app, word), kBadInput);
  }
  if (app.get_subcommands().empty() && !word.empty()) {
    return complain(fmt::format("no option '{}'; 'camlaw --help' shows the usage", word),
                    kBadInput);
  }
  std::string what = error.what();
  constexpr std::string_view kOverride = " was given a disallowed flag override";
  if (what.ends_with(kOverride)) {
    what = fmt::format("--{} takes no value", what.substr(0, what.size() - kOverride.size()));
  }
  return complain(fmt::format("{}; 'camlaw --help' shows the usage", what), kBadInput);
}

/// What was printed must have arrived: a full disk behind standard output is a failure too. Where
/// its reader has gone, the program ends by the signal that would have ended it at once, now that
/// its files are written.
int finish(int status) {
  const bool arrived = flush_printed();
  if (arrived && !is_reader_gone()) return status;
  if (is_reader_gone()) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  return complain("cannot write to standard output", kFailed);
}

/// --quiet, for the program and each command.
void add_quiet(CLI::App& app) {
  std::vector<CLI::App*> all = app.get_subcommands({});
  all.push_back(&app);
  for (CLI::App* command : all) {
    command
        ->add_flag_callback(
            "-q,--quiet", [] { set_quiet(true); },
            "print nothing but what was asked for: no progress, no word of files written")
        ->disable_flag_override();
  }
}

}  // namespace

CLI::Option* add_switch(CLI::App& command, const std::string& name, bool& on,
                        const std::string& help) {
  return command.add_flag(name, on, help)->disable_flag_override();
}

void add_set_option(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option("--set", settings,
                  "set a variable or constant: name=value, such as --set 'stroke=30 mm'")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
}

namespace {

/// Every command of the program.
void add_commands(CLI::App& app, int& status) {
  app.set_version_flag("--version", version_text,
                       "Print the versions of the program and of the libraries behind it");
  app.require_subcommand(1);
  add_laws_command(app);
  add_mechanisms_command(app);
  add_law_command(app);
  add_study_command(app);
  add_reproduce_command(app, status);
  add_check_command(app, status);
  add_evaluate_command(app, status);
  add_verify_command(app, status);
  add_export_command(app, status);
  add_optimize_command(app, status);
  add_pareto_command(app, status);
  add_front_command(app, status);
  add_synthesize_command(app, status);
  add_fit_command(app);
  add_report_command(app, status);
  add_completion_command(app);
  add_man_command(app);
  add_quiet(app);
  add_examples(app, {{"camlaw laws", "every motion law with its constants"},
                     {"camlaw law modified-sine", "one law: its peaks, proved"},
                     {"camlaw optimize problems/spine_cutter/least_radius.toml",
                      "the best design of a problem file, and a verdict on it"},
                     {"camlaw optimize --help", "what a command takes, with examples"}});
}

/// Parses and carries out a command; throws what the command throws.
int carry_out(int argc, const char* const* argv) {
  CLI::App app("camlaw: cam motion laws and mechanisms", "camlaw");
  int status = kDone;
  add_commands(app, status);
  try {
    app.parse(argc, argv);
    return finish(status);
  } catch (const CLI::Success& request) {  // --help, --version
    return finish(app.exit(request));
  } catch (const CLI::ParseError& error) {
    return usage_error(app, error, argc, argv);
  }
}

}  // namespace

int run(int argc, const char* const* argv) {
  try {
    reserve_standard_streams();
    std::signal(SIGPIPE, SIG_IGN);  // finish() ends as it would
    return carry_out(argc, argv);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return complain("there is not enough memory for this", kFailed);
  } catch (const NotSolved& error) {
    return complain(error.what(), kNotSolved);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailed);
  }
}

}  // namespace camlaw::cli
