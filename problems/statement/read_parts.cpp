// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "problems/statement/parts.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

/// Refuses a name that stands for something else in the file.
void check_part_name(const Entry& table, const Mechanism& mechanism) {
  const auto is_it = [&](const auto& named) { return named.name == table.key; };
  const auto has = [&](const auto& all) { return std::any_of(all.begin(), all.end(), is_it); };
  const bool is_parameter =
      std::any_of(mechanism.parameters.begin(), mechanism.parameters.end(),
                  [&](const auto& p) { return p.name == table.key || p.symbol == table.key; });
  if (!is_parameter && !has(mechanism.responses) && !has(mechanism.peaks) &&
      !has(mechanism.inputs) && table.key != "law") {
    return;
  }
  refuse(table,
         fmt::format("{} is already the name of something else in {}; give the part another name",
                     table.key, mechanism.name));
}

/// Refuses what the file states of a part's numbers beside it.
void check_part_alone(const Entry& file, const Entry& table, const ProblemStatement& problem,
                      const PartStatement& part) {
  for (const std::size_t i : part.parameters) {
    const MechanismParameter& p = problem.mechanism->parameters[i];
    const StatedParameter stated = stated_parameter(file, p);
    const Entry* other = stated.fixed != nullptr ? stated.fixed : stated.varying;
    if (other != nullptr) {
      refuse(*other, fmt::format("{} comes with {}, from {}; drop this entry", p.name, table.path,
                                 part.catalogue));
    }
    if (problem.told_by_motion.contains(i)) {
      refuse(table, fmt::format("the motion sets the {}; drop that column", p.name));
    }
    if (const PartStatement* known = part_of(problem, i)) {
      refuse(table, fmt::format("{} comes with {} already", p.name, known->name));
    }
  }
  for (const std::string& input : part.inputs) {
    if (const PartStatement* known = part_with_input(problem, input)) {
      refuse(table, fmt::format("{} comes with {} already", input, known->name));
    }
  }
}

/// Leaves of a part the items that the file names.
void read_choose(const Entry& choose, PartStatement& part) {
  std::vector<PartItem> kept;
  const auto keep = [&](const Entry& name) {
    const std::string& text = text_of(name);
    const std::size_t i = located(name, [&] { return item_named(part, text); });
    const bool twice = std::any_of(kept.begin(), kept.end(),
                                   [&](const auto& k) { return k.name == part.items[i].name; });
    if (twice) refuse(name, fmt::format("'{}' is listed twice", part.items[i].name));
    kept.push_back(part.items[i]);
  };
  if (choose.kind == Entry::Kind::Text && choose.text == "all") return;
  if (choose.kind == Entry::Kind::List) {
    if (choose.items.empty()) refuse(choose, "the list is empty; name what to choose from");
    for (const Entry& name : choose.items) keep(name);
  } else {
    expect(choose, Entry::Kind::Text, "a name of the catalogue, a list of names, or \"all\"");
    keep(choose);
  }
  part.items = std::move(kept);
}

void read_part(const Entry& file, const Entry& table, ProblemStatement& problem) {
  expect(table, Entry::Kind::Table, "a table, [parts.roller] with catalogue = \"rollers.csv\"");
  check_keys(table, {"catalogue", "choose", "start"});
  check_part_name(table, *problem.mechanism);
  const Entry* catalogue = find(table, "catalogue");
  if (catalogue == nullptr) {
    refuse(table, "catalogue is missing; name a file, such as catalogue = \"rollers.csv\"");
  }
  const std::string& text = table_text(*catalogue, problem.files);
  PartStatement part = located(
      *catalogue, [&] { return parse_catalogue(text, catalogue->text, *problem.mechanism); });
  part.name = table.key;
  check_part_alone(file, table, problem, part);
  if (const Entry* choose = find(table, "choose")) read_choose(*choose, part);
  std::size_t start = 0;
  if (const Entry* name = find(table, "start")) {
    const std::string& wanted = text_of(*name);
    start = located(*name, [&] { return item_named(part, wanted); });
  }
  problem.parts.push_back(std::move(part));
  start_with(problem, table.key, start);
}

}  // namespace

void read_parts(const Entry& file, ProblemStatement& problem) {
  const Entry* parts = find(file, "parts");
  if (parts == nullptr) return;
  expect(*parts, Entry::Kind::Table, "tables, such as [parts.roller]");
  for (const Entry& table : parts->items) read_part(file, table, problem);
}

}  // namespace camlaw::problems
