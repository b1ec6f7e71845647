// SPDX-License-Identifier: MIT
#include "problems/statement/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "numerics/text/names.h"
#include "numerics/text/quotes.h"
#include "problems/statement/buildable.h"

namespace camlaw::problems {
namespace {

PartStatement& part_named(ProblemStatement& problem, std::string_view name) {
  return *std::find_if(problem.parts.begin(), problem.parts.end(),
                       [&](const PartStatement& part) { return part.name == name; });
}

}  // namespace

const PartStatement* find_part(const ProblemStatement& problem, std::string_view name) {
  const auto& all = problem.parts;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& part) { return part.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const PartStatement* part_of(const ProblemStatement& problem, std::size_t parameter) {
  const auto& all = problem.parts;
  const auto found = std::find_if(all.begin(), all.end(), [&](const PartStatement& part) {
    return std::find(part.parameters.begin(), part.parameters.end(), parameter) !=
           part.parameters.end();
  });
  return found == all.end() ? nullptr : &*found;
}

const PartStatement* part_with_input(const ProblemStatement& problem, std::string_view input) {
  const auto& all = problem.parts;
  const auto found = std::find_if(all.begin(), all.end(), [&](const PartStatement& part) {
    return std::find(part.inputs.begin(), part.inputs.end(), input) != part.inputs.end();
  });
  return found == all.end() ? nullptr : &*found;
}

std::size_t item_named(const PartStatement& part, std::string_view name) {
  const std::string_view written = trimmed(name);
  for (const std::string& wanted : {folded(written), folded(without_quotes(written))}) {
    for (std::size_t i = 0; i < part.items.size(); ++i) {
      if (folded(part.items[i].name) == wanted) return i;
    }
  }
  std::vector<std::string> known;
  for (const PartItem& item : part.items) known.push_back(item.name);
  refuse_name(fmt::format("{} has no {}", part.catalogue, part.name), name, known);
}

void put_item(const PartStatement& part, std::size_t item, std::vector<double>& constants) {
  for (std::size_t i = 0; i < part.parameters.size(); ++i) {
    constants[part.parameters[i]] = part.items[item].values[i];
  }
}

void start_with(ProblemStatement& problem, std::string_view part, std::size_t item) {
  PartStatement& its = part_named(problem, part);
  its.start = item;
  put_item(its, item, problem.constants);
  problem.stated.insert(its.parameters.begin(), its.parameters.end());
  for (std::size_t i = 0; i < its.inputs.size(); ++i) {
    problem.buildable.inputs[its.inputs[i]] = its.items[item].inputs[i];
  }
  if (!its.inputs.empty()) follow_parts(problem);
}

void keep_item(ProblemStatement& problem, std::string_view part, std::size_t item) {
  PartStatement& its = part_named(problem, part);
  PartItem kept = its.items[item];
  its.items = {std::move(kept)};
  start_with(problem, part, 0);
}

bool chooses_part(const ProblemStatement& problem) {
  return std::any_of(problem.parts.begin(), problem.parts.end(),
                     [](const PartStatement& part) { return part.is_chosen(); });
}

}  // namespace camlaw::problems
