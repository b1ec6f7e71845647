// SPDX-License-Identifier: MIT
#include "tests/cli/shell.h"
#include "tests/paths.h"

namespace camlaw::cli::terminal_test {
namespace {

/// What the program prints on a terminal, which script(1) makes.
std::string on_terminal(const Folder& folder, const std::string& environment) {
  const std::string command = "env -u NO_COLOR TERM=xterm " + environment + " " +
                              testing::program() + " evaluate problems/cams/roller_least_base.toml";
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
  CHECK_THAT(done({"evaluate", testing::source("problems/cams/roller_least_base.toml")}),
             !Contains("\x1b"));
}

TEST_CASE("an answer ends with what one would do next, unless it is unwanted", "[program]") {
  const ProjectFolder folder;
  const std::string file = "problems/cams/roller_least_base.toml";
  const auto says = [&](const std::string& command) { return shell(folder, command).out; };
  CHECK(says("camlaw check " + file).ends_with("next: camlaw optimize " + file + "\n"));
  CHECK_THAT(says("camlaw check problems/spine_cutter/front.toml"),
             Contains("next: camlaw pareto problems/spine_cutter/front.toml"));
  CHECK_THAT(says("camlaw evaluate " + file), !Contains("next:"));
  CHECK_THAT(says("camlaw evaluate " + file + " --set 'base_radius=40 mm'"),
             Contains("next: camlaw optimize " + file + " --set 'base_radius=40 mm'\n"));
  const std::string found = says("camlaw optimize " + file + " --out 'my cam'");
  CHECK(found.ends_with("next: camlaw report 'my cam/result.json'\n"));
  CHECK(shell(folder, found.substr(found.rfind("next: ") + 6)).status == 0);
  CHECK_THAT(says("camlaw --quiet check " + file), !Contains("next:"));
  CHECK_THAT(says("camlaw optimize " + file + " --json --out out"), !Contains("next:"));
}

TEST_CASE("words of optimisation are explained where they are printed", "[program]") {
  const ProjectFolder folder;
  const auto says = [&](const std::string& command) { return shell(folder, command).out; };
  const std::string checked = says("camlaw check problems/cams/roller_least_base.toml");
  CHECK_THAT(checked, Contains("By default, as the file does not state them, it has ") &&
                          Contains("displacements are in strokes: 0 is where the stroke begins") &&
                          Contains("jointly: with everything that it depends on varying together"));
  CHECK_THAT(checked.substr(checked.find("By default")), Contains("offset = 0 mm"));
  CHECK_THAT(says("camlaw pareto problems/spine_cutter/front.toml --points 4"),
             Contains("(the best of each objective alone)") &&
                 Contains("(the worst of each on the front)") && Contains("larger is better)"));
  CHECK_THAT(shell(folder, "camlaw pareto problems/cams/roller_least_base.toml").err,
             Contains("write a table [[objectives]] with minimize"));
}

}  // namespace camlaw::cli::terminal_test
