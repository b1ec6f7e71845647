// SPDX-License-Identifier: MIT
#include "output/answers/objective_cases.h"

#include "optim/cycle/scales.h"
#include "optim/verdict/limits.h"
#include "output/answers/limit_text.h"
#include "output/document/formatting.h"
#include "problems/statement/bind.h"
#include "problems/statement/cases.h"
#include "problems/statement/ranges.h"

namespace camlaw::cli {
namespace {

/// The design with the objective of one case as the only thing that is asked.
problems::ProblemStatement in_one_case(const problems::ProblemStatement& design,
                                       const problems::LoadCase& load) {
  problems::ProblemStatement one = design;
  problems::ObjectiveStatement objective = design.objectives.front();
  objective.response = problems::in_case(*design.mechanism, objective.one_case, load);
  objective.over.reset();
  objective.of_cases = nullptr;
  objective.of_ranges = nullptr;
  objective.one_case = objective.one_value = {};
  one.objectives = {problems::over_ranges(design, std::move(objective))};
  one.constraints.clear();
  one.variables.clear();
  return one;
}

}  // namespace

Table objective_cases(const problems::ProblemStatement& design) {
  Table table{.key = "objective_cases", .columns = {}};
  const problems::ObjectiveStatement& objective = design.objectives.front();
  if (!objective.over) return table;
  table.columns = {words("objective in case", "case"),
                   numbers("value", "value"),
                   words("unit", "unit"),
                   numbers("weight", "weight"),
                   words("at", ""),
                   data("worst_angle_deg"),
                   data("worst_at")};
  table.columns[3].in_text = table.columns[3].on_page =
      *objective.over == problems::OverCases::Mean;
  for (const problems::LoadCase& load : design.cases) {
    const problems::ProblemStatement one = in_one_case(design, load);
    const problems::BoundProblem bound(one, true);
    const optim::Problem problem =
        bound.problem(std::vector<std::size_t>(bound.choices().size(), 0));
    const optim::ObjectiveReport report =
        optim::objective_report(problem, optim::scales(problem, {}), {}, false);
    const ObjectivePlace place = objective_place(one, report.angle);
    table.add({load.name, Cell(in_digits(report.value), report.value),
               problem.objective().response.unit, Cell(in_digits(load.weight), load.weight),
               place.words, datum(place.angle), datum(place.worst_at)});
  }
  return table;
}

}  // namespace camlaw::cli
