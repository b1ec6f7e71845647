// SPDX-License-Identifier: MIT
#include "tests/cli/console_page.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "tests/paths.h"

namespace camlaw::cli {
namespace {

const std::string kCut = "...";

/// The line as it is, or its beginning where "..." ends what is shown.
bool shows_line(const std::string& shown, const std::string& line) {
  if (!shown.ends_with(kCut)) return shown == line;
  return line.starts_with(shown.substr(0, shown.size() - kCut.size()));
}

}  // namespace

std::vector<ConsoleStep> console_steps(const std::string& page) {
  std::vector<ConsoleStep> steps;
  std::istringstream text(page);
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      inside = line == "```console";
    } else if (inside && line.starts_with("$ ")) {
      steps.push_back({line.substr(2), {}});
    } else if (inside) {
      REQUIRE_FALSE(steps.empty());
      steps.back().lines.push_back(line);
    }
  }
  return steps;
}

std::string console_difference(const Words& shown, const std::string& output) {
  const std::string no_line = "'...' stands for no line";
  Words lines = lines_after(output, "");
  std::erase(lines, "");
  auto next = lines.begin();
  bool cut = false;
  for (const std::string& line : shown) {
    if (line.empty()) continue;
    if (line == kCut) {
      cut = true;
      continue;
    }
    const auto limit = cut || next == lines.end() ? lines.end() : next + 1;
    const auto found = std::find_if(
        next, limit, [&](const std::string& printed) { return shows_line(line, printed); });
    if (found == limit) {
      const std::string instead = next == lines.end() ? "no more" : "'" + *next + "'";
      return "'" + line + "' is not " + (cut ? "behind " : "where the output has ") + instead;
    }
    if (cut && found == next) return no_line;
    next = found + 1;
    cut = false;
  }
  if (cut) return next == lines.end() ? no_line : "";
  return next == lines.end() ? "" : "nothing says that '" + *next + "' is left out";
}

void check_page(const ProjectFolder& folder, const std::string& page, std::size_t least) {
  const auto steps = console_steps(read(testing::source(page)));
  CHECK(steps.size() >= least);
  for (const ConsoleStep& step : steps) {
    INFO(step.command);
    const Outcome outcome = shell(folder, step.command);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(console_difference(step.lines, outcome.out) == "");
  }
}

}  // namespace camlaw::cli
