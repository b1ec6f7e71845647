// SPDX-License-Identifier: MIT
#include "tests/cli/shell.h"

namespace camlaw::cli {
namespace {

/// A command of the tutorial and the lines that it is said to print.
struct Step {
  std::string command;
  Words lines;
};

/// What stands between "```console" and "```": "$ command", then its lines.
std::vector<Step> steps_of(const std::string& page) {
  std::vector<Step> steps;
  std::istringstream text(page);
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      inside = line == "```console";
    } else if (inside && line.starts_with("$ ")) {
      steps.push_back({line.substr(2), {}});
    } else if (inside && line != "...") {
      REQUIRE_FALSE(steps.empty());
      steps.back().lines.push_back(line);
    }
  }
  return steps;
}

}  // namespace

TEST_CASE("the tutorial's commands print what it says", "[documents][heavy]") {
  const ProjectFolder folder;
  const auto steps = steps_of(read(CAMLAW_SOURCE_DIR "/docs/tutorial.md"));
  CHECK(steps.size() >= 8);
  for (const Step& step : steps) {
    INFO(step.command);
    const Outcome outcome = shell(folder, step.command);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    for (const std::string& line : step.lines) {
      if (!line.empty()) CHECK_THAT(outcome.out, Contains(line));
    }
  }
  CHECK(read(folder / "results/least_force/cycle.svg") ==
        read(CAMLAW_SOURCE_DIR "/docs/tutorial/spine_cutter.svg"));
  CHECK(read(folder / "results/disc_cam/profile.svg") ==
        read(CAMLAW_SOURCE_DIR "/docs/tutorial/disc_cam.svg"));
  CHECK(read(folder / "results/worn/fit.svg") ==
        read(CAMLAW_SOURCE_DIR "/docs/tutorial/worn_cam.svg"));
}

}  // namespace camlaw::cli
