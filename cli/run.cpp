// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/run_limits.h"
#include "cli/version_text.h"
#include "output/document/printing.h"
#include "output/document/terminal.h"

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

}  // namespace

/// The commands in the order of --help, a line for each: its name, after which the function that
/// makes it is called (laws_command), which NAME_command.cpp defines.
#define CAMLAW_COMMANDS(COMMAND) \
  COMMAND(laws)                  \
  COMMAND(mechanisms)            \
  COMMAND(new)                   \
  COMMAND(examples)              \
  COMMAND(law)                   \
  COMMAND(study)                 \
  COMMAND(reproduce)             \
  COMMAND(check)                 \
  COMMAND(evaluate)              \
  COMMAND(verify)                \
  COMMAND(export)                \
  COMMAND(optimize)              \
  COMMAND(pareto)                \
  COMMAND(front)                 \
  COMMAND(sweep)                 \
  COMMAND(synthesize)            \
  COMMAND(fit)                   \
  COMMAND(tolerance)             \
  COMMAND(report)                \
  COMMAND(completion)            \
  COMMAND(man)

#define CAMLAW_DECLARED(name) Command name##_command();
CAMLAW_COMMANDS(CAMLAW_DECLARED)
#undef CAMLAW_DECLARED

CommandTree camlaw_program() {
#define CAMLAW_MADE(name) name##_command(),
  return {"camlaw",
          "camlaw: cam motion laws and mechanisms",
          {CAMLAW_COMMANDS(CAMLAW_MADE)},
#undef CAMLAW_MADE
          {{"camlaw laws", "every motion law with its constants"},
           {"camlaw law modified-sine", "one law: its peaks, proved"},
           {"camlaw new disc-cam-roller", "a problem file of your own to start from"},
           {"camlaw optimize problems/spine_cutter/least_radius.toml",
            "the best design of a problem file, and a verdict on it"},
           {"camlaw optimize --help", "what a command takes, with examples"}},
          version_text};
}

int run(int argc, const char* const* argv) {
  try {
    reserve_standard_streams();
    std::signal(SIGPIPE, SIG_IGN);  // finish() ends as it would
    std::signal(SIGXFSZ, SIG_IGN);  // what cannot be written says so, and leaves nothing behind
    const CommandTree program = camlaw_program();
    const Command* const command = parsed(program, argc, argv);
    return finish(command != nullptr ? command->run() : kDone);
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
