// SPDX-License-Identifier: MIT
#include "tests/cli/shell.h"

namespace camlaw::cli {
namespace {

/// What the program prints on a terminal, which script(1) makes.
std::string on_terminal(const Folder& folder, const std::string& environment) {
  const std::string command = "env -u NO_COLOR TERM=xterm " + environment +
                              " " CAMLAW_PROGRAM " evaluate problems/cams/roller_least_base.toml";
  const Outcome outcome = shell(folder, "script -qec '" + command + "' /dev/null </dev/null");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("met") && Contains("pressure_angle"));
  return outcome.out;
}

}  // namespace

TEST_CASE("verdicts are coloured on a terminal alone, and not where that is unwanted",
          "[program]") {
  const ProjectFolder folder;
  CHECK_THAT(on_terminal(folder, ""), Contains("\x1b[1m\x1b[32mmet\x1b[0m"));
  CHECK_THAT(on_terminal(folder, "NO_COLOR=1"), !Contains("\x1b"));
  CHECK_THAT(on_terminal(folder, "TERM=dumb"), !Contains("\x1b"));
  CHECK_THAT(done({"evaluate", CAMLAW_SOURCE_DIR "/problems/cams/roller_least_base.toml"}),
             !Contains("\x1b"));
}

}  // namespace camlaw::cli
