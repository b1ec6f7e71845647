// SPDX-License-Identifier: MIT
// The defaults that docs/problem-files.md prints beside the parameters of a machine are those that
// the program takes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "machines/registry.h"
#include "numerics/text/names.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::documented_defaults_test {
namespace {

std::vector<std::string> texts_between(std::string_view text, char mark) {
  std::vector<std::string> result;
  for (const std::string_view one : parted(text, mark)) result.emplace_back(trimmed(one));
  return result;
}

/// The machines of a heading, "### geneva, geneva-spherical".
std::vector<const Mechanism*> machines_of(const std::string& heading) {
  std::vector<const Mechanism*> result;
  for (const std::string& name : texts_between(heading.substr(4), ',')) {
    const auto& all = mechanisms();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Mechanism& m) { return m.name == name; });
    if (found == all.end()) return {};
    result.push_back(&*found);
  }
  return result;
}

/// The names in a cell such as "`friction_torque`, `load_torque`".
std::vector<std::string> names_in(const std::string& cell) {
  std::vector<std::string> result;
  const std::vector<std::string> parts = texts_between(cell, '`');
  for (std::size_t i = 1; i < parts.size(); i += 2) result.push_back(parts[i]);
  return result;
}

/// What a row states for a machine's parameter: "90; 80; 120" has one number for each machine,
/// "31.5, 16.3" one for each name.
std::string stated_for(const std::string& cell, std::size_t machine, std::size_t name) {
  const std::vector<std::string> each = texts_between(cell, ';');
  const std::vector<std::string> named =
      texts_between(each.size() > 1 ? each.at(machine) : cell, ',');
  return named.size() > 1 ? named.at(name) : named.front();
}

}  // namespace

TEST_CASE("documented defaults of machines are those of the program", "[docs]") {
  std::istringstream page(testing::read(testing::source("docs/problem-files.md")));
  std::vector<const Mechanism*> machines;
  std::optional<std::size_t> column;
  int compared = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("### ")) machines = machines_of(line);
    if (!line.starts_with("|")) {
      column.reset();
      continue;
    }
    const std::vector<std::string> cells = texts_between(line, '|');
    if (!column) {
      const auto at = std::find(cells.begin(), cells.end(), "default");
      column = static_cast<std::size_t>(at - cells.begin());
      continue;
    }
    if (*column >= cells.size() || cells[*column].empty()) continue;
    const std::vector<std::string> names = names_in(cells.at(1));
    for (std::size_t m = 0; m < machines.size(); ++m) {
      for (const MechanismParameter& p : machines[m]->parameters) {
        const auto name = std::find(names.begin(), names.end(), p.name);
        if (name == names.end()) continue;
        INFO(machines[m]->name << ": " << p.name);
        const auto k = static_cast<std::size_t>(name - names.begin());
        CHECK(std::stod(stated_for(cells[*column], m, k)) == Approx(p.default_value));
        ++compared;
      }
    }
  }
  CHECK(compared > 100);
}

}  // namespace camlaw::problems::documented_defaults_test
