// SPDX-License-Identifier: MIT
#include "python/bindings/problem_state.h"

#include <fmt/format.h>

#include <algorithm>

#include "problems/law_files/json_text.h"
#include "problems/statement/held_files.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "python/bindings/running.h"

namespace camlaw::python {

using problems::ProblemStatement;

namespace {

/// The first law of this family among those that a statement was read with, with other values.
Member law_with(const std::vector<Member>& laws, const ArgumentsState& state) {
  const auto law = std::find_if(laws.begin(), laws.end(), [&](const Member& member) {
    return member.family->name == state.first;
  });
  if (law == laws.end()) {
    throw std::invalid_argument(fmt::format(
        "the problem was pickled with a law '{}', which it does not have", state.first));
  }
  Member result = *law;
  result.arguments.values() = state.second;
  return result;
}

}  // namespace

ProblemState problem_state_of(const StatedProblem& problem) {
  const ProblemStatement& statement = problem.statement;
  std::vector<double> starts;
  for (const problems::VariableStatement& v : statement.variables) starts.push_back(v.start);
  std::vector<ArgumentsState> laws;
  for (Member law : statement.laws) laws.emplace_back(law.family->name, law.arguments.values());
  std::vector<PartState> parts;
  for (const problems::PartStatement& part : statement.parts) {
    if (!part.is_chosen()) parts.emplace_back(part.name, part.items.front().name);
  }
  return {statement.text,         statement.source,
          statement.settings,     problems::laws_to_json(statement.files.laws).dump(),
          statement.files.tables, statement.constants,
          std::move(starts),      std::move(laws),
          std::move(parts)};
}

StatedProblem problem_of(const ProblemState& state) {
  const Unlocked released;
  const auto& [text, source, settings, law_files, tables, constants, starts, laws, parts] = state;
  problems::HeldFiles files{problems::laws_from_json(problems::parse_json(law_files)), tables};
  StatedProblem result{problems::read_problem(text, source, std::move(files))};
  ProblemStatement& statement = result.statement;
  problems::set_values(statement, settings);
  for (const auto& [name, row] : parts) {
    const problems::PartStatement* part = problems::find_part(statement, name);
    if (part == nullptr) {
      throw std::invalid_argument(
          fmt::format("the problem was pickled with a part '{}', which it does not have", name));
    }
    problems::keep_item(statement, name, problems::item_named(*part, row));
  }
  statement.constants = constants;
  for (std::size_t i = 0; i < statement.variables.size(); ++i) {
    statement.variables[i].start = starts.at(i);
  }
  std::vector<Member> at_design;
  for (const ArgumentsState& law : laws) at_design.push_back(law_with(statement.laws, law));
  statement.laws = std::move(at_design);
  return result;
}

}  // namespace camlaw::python
