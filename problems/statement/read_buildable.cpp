// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "problems/statement/buildable.h"
#include "problems/statement/parts.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// Refuses a key that is a parameter of the machine, which has its place already.
void check_no_parameter(const Entry& entry, const Mechanism& mechanism) {
  const auto& all = mechanism.parameters;
  if (std::none_of(all.begin(), all.end(), [&](const auto& p) { return p.name == entry.key; })) {
    return;
  }
  refuse(entry, fmt::format("{} is a parameter of {}; state it in [constants]", entry.key,
                            mechanism.name));
}

void read_input(const Entry& entry, ProblemStatement& problem) {
  const BuildableInput& input = *find_input(*problem.mechanism, entry.key);
  if (const PartStatement* part = part_with_input(problem, input.name)) {
    refuse(entry, fmt::format("{} comes with parts.{}, from {}; drop this entry", input.name,
                              part->name, part->catalogue));
  }
  const double value = quantity_of(entry, input.unit);
  problem.buildable.inputs[input.name] =
      located(entry, [&] { return accepted_input(input, value); });
}

}  // namespace

void read_buildable(const Entry& file, ProblemStatement& problem) {
  const Entry* table = find(file, "buildable");
  if (table == nullptr) return;
  const Mechanism& mechanism = *problem.mechanism;
  expect(*table, Kind::Table, "a table, [buildable]");
  if (mechanism.checks.empty()) {
    refuse(*table, fmt::format("{} has no such checks: [buildable] is for cams with a follower",
                               mechanism.name));
  }
  std::vector<std::string> known{"require", "material"};
  for (const BuildableInput& input : mechanism.inputs) known.push_back(input.name);
  for (const Entry& entry : table->items) check_no_parameter(entry, mechanism);
  check_keys(*table, known);
  for (const Entry& entry : table->items) {
    if (entry.key == "require") {
      expect(entry, Kind::Truth, "true or false");
      problem.buildable.require = entry.integer != 0;
    } else if (entry.key == "material") {
      problem.buildable.material = printable_text(entry);
    } else {
      read_input(entry, problem);
    }
  }
  located(*table, [&] { limit_to_checks(problem); });
}

}  // namespace camlaw::problems
