// SPDX-License-Identifier: MIT
#include <regex>

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

/// A picture is that of the page where its words are the same and its numbers by a last digit of
/// two, which processors may round otherwise.
void check_alike(const std::string& drawn, const std::string& kept) {
  static const std::regex number("-?[0-9]+\\.[0-9]+");
  CHECK(std::regex_replace(drawn, number, "#") == std::regex_replace(kept, number, "#"));
  std::sregex_iterator a(drawn.begin(), drawn.end(), number), b(kept.begin(), kept.end(), number);
  double most = 0;
  for (const std::sregex_iterator end; a != end && b != end; ++a, ++b) {
    most = std::max(most, std::abs(std::stod(a->str()) - std::stod(b->str())));
  }
  CHECK(most < 0.025);
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
  check_alike(read(folder / "results/least_force/cycle.svg"),
              read(CAMLAW_SOURCE_DIR "/docs/tutorial/spine_cutter.svg"));
  check_alike(read(folder / "results/disc_cam/profile.svg"),
              read(CAMLAW_SOURCE_DIR "/docs/tutorial/disc_cam.svg"));
  check_alike(read(folder / "results/worn/fit.svg"),
              read(CAMLAW_SOURCE_DIR "/docs/tutorial/worn_cam.svg"));
}

}  // namespace camlaw::cli
