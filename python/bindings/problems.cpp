// SPDX-License-Identifier: MIT
#include "python/bindings/problems.h"

#include <algorithm>
#include <cmath>

#include "machines/registry.h"
#include "optim/problem/check_derivatives.h"
#include "output/answers/buildable_output.h"
#include "output/answers/check_output.h"
#include "output/answers/cycle_figure.h"
#include "output/answers/mechanism_output.h"
#include "output/answers/optimum_output.h"
#include "output/answers/possible.h"
#include "output/answers/warnings.h"
#include "output/figure/profile_figure.h"
#include "problems/statement/buildable.h"
#include "problems/statement/default_machine.h"
#include "problems/statement/parameters.h"
#include "python/bindings/laws.h"
#include "python/bindings/module.h"

namespace camlaw::python {
namespace {

using problems::EvaluatedResponse;
using problems::ProblemStatement;

StatedProblem problem_of_text(const std::string& text, const std::string& source) {
  return {problems::read_problem(text, source)};
}

StatedProblem problem_with(const StatedProblem& problem, const std::vector<std::string>& settings) {
  StatedProblem result = problem;
  problems::set_values(result.statement, settings);
  return result;
}

nb::list variables_of(const StatedProblem& problem) {
  nb::list result;
  for (const problems::VariableStatement& v : problem.statement.variables) {
    nb::dict row;
    row["name"] = v.name;
    row["unit"] = v.unit;
    row["lower"] = v.lower;
    row["upper"] = v.upper;
    row["start"] = v.start;
    row["integer"] = v.integer;
    row["values"] = v.values;
    result.append(row);
  }
  return result;
}

nb::dict constants_of(const StatedProblem& problem) {
  nb::dict result;
  const auto& parameters = problem.statement.mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    result[nb::cast(parameters[i].name)] =
        nb::make_tuple(problem.statement.constants[i], parameters[i].unit);
  }
  return result;
}

nb::list objectives_of(const StatedProblem& problem) {
  nb::list result;
  for (const problems::ObjectiveStatement& o : problem.statement.objectives) {
    result.append(nb::make_tuple(o.response.name, o.response.unit,
                                 o.sense == optim::Sense::Minimize ? "minimize" : "maximize"));
  }
  return result;
}

nb::list constraints_of(const StatedProblem& problem) {
  nb::list result;
  for (const problems::ConstraintStatement& c : problem.statement.constraints) {
    result.append(nb::make_tuple(c.response.name, c.response.unit, c.lower, c.upper));
  }
  return result;
}

nb::dict dict_of(const EvaluatedResponse& response) {
  nb::dict row;
  row["response"] = response.name;
  row["value"] = response.is_curve ? std::nan("") : response.value;
  row["lowest"] = response.is_curve ? response.lowest : std::nan("");
  row["lowest_at"] = response.is_curve ? response.lowest_at : std::nan("");
  row["highest"] = response.is_curve ? response.highest : std::nan("");
  row["highest_at"] = response.is_curve ? response.highest_at : std::nan("");
  row["unit"] = response.unit;
  row["along"] = response.along;
  row["curve"] = response.is_curve;
  row["proved"] = response.proved;
  row["meaning"] = response.meaning;
  return row;
}

/// Every response, how the limits stand, whether it can be built, what is to be warned of.
nb::dict evaluated(const StatedProblem& problem) {
  std::vector<EvaluatedResponse> responses;
  std::vector<optim::LimitReport> limits;
  problems::Buildability built;
  cli::Warnings warnings;
  {
    const nb::gil_scoped_release released;
    responses = problems::evaluate(problem.statement);
    cli::check_possible(problem.statement.source, problem.statement, responses);
    limits = problems::standing(problem.statement);
    built = problems::buildability(problem.statement);
    warnings = cli::warnings_of(problem.statement);
  }
  nb::list rows;
  for (const EvaluatedResponse& response : responses) rows.append(dict_of(response));
  nb::dict result;
  result["responses"] = rows;
  result["limits"] = list_of(limits);
  result["buildable"] = python_of(cli::buildable_json(built));
  result["warnings"] = warnings;
  return result;
}

nb::dict dict_of(const optim::DerivativeCheck& found, const std::string& label) {
  nb::dict row;
  row["problem"] = label;
  row["derivatives"] = found.entries;
  row["agrees"] = found.agrees && found.shapes.empty();
  row["worst_error"] = found.worst.error;
  row["response"] = found.worst.response;
  row["variable"] = found.worst.variable;
  row["second"] = found.worst.second;
  row["shapes"] = found.shapes;
  return row;
}

/// Every derivative against differences: of each law to choose from, and each objective.
nb::list checked_derivatives(const StatedProblem& stated) {
  const problems::BoundProblem bound(stated.statement);
  const std::size_t laws = stated.statement.laws.empty() ? 1 : stated.statement.laws.size();
  const auto& objectives = stated.statement.objectives;
  nb::list result;
  for (std::size_t i = 0; i < laws * objectives.size(); ++i) {
    std::vector<std::size_t> chosen(bound.choices().size(), 0);
    std::string label = objectives[i / laws].response.name;
    if (stated.statement.chooses_law()) {
      chosen.front() = i % laws;
      label += ", law " + bound.choices().front().options[i % laws];
    }
    optim::DerivativeCheck found;
    {
      const nb::gil_scoped_release released;
      const optim::Problem problem = bound.problem(chosen).alone(i / laws);
      found = optim::check_derivatives(problem, problem.start());
    }
    result.append(dict_of(found, label));
  }
  return result;
}

/// What variables and limits are divided by, and their tolerances.
nb::object scaling_of(const StatedProblem& stated) {
  if (stated.statement.objectives.empty()) {
    throw std::invalid_argument("scaling: the problem has no objective, so that nothing is scaled");
  }
  const problems::BoundProblem bound(stated.statement);
  const optim::Problem problem =
      bound.problem(std::vector<std::size_t>(bound.choices().size(), 0)).alone(0);
  return python_of(cli::json_of(cli::scaling_table(problem)));
}

/// The formula of a response as it is recorded.
std::string formula_of(const problems::Mechanism& mechanism, const std::string& response) {
  return cli::json_of(cli::formula_document(mechanism, response))["formula"].get<std::string>();
}

nb::dict dict_of(const problems::Mechanism& mechanism) {
  nb::list parameters, responses, peaks;
  for (const problems::MechanismParameter& p : mechanism.parameters) {
    nb::dict row;
    row["parameter"] = p.name;
    row["symbol"] = p.symbol;
    row["default"] = p.default_value;
    row["lower"] = p.low;
    row["upper"] = p.high;
    row["unit"] = p.unit;
    row["integer"] = p.integer;
    row["meaning"] = p.meaning;
    parameters.append(row);
  }
  for (const problems::MechanismResponse& r : mechanism.responses) {
    nb::dict row;
    row["response"] = r.name;
    row["kind"] = r.curve ? "curve" : "number";
    row["unit"] = r.unit;
    row["meaning"] = r.meaning;
    responses.append(row);
  }
  for (const problems::NamedPeak& p : mechanism.peaks) {
    nb::dict row;
    row["response"] = p.name;
    row["kind"] = "peak of " + p.curve;
    row["unit"] = "";
    row["meaning"] = p.meaning;
    responses.append(row);
  }
  nb::dict result;
  result["name"] = mechanism.name;
  result["title"] = mechanism.title;
  result["source"] = mechanism.source;
  result["parameters"] = parameters;
  result["responses"] = responses;
  return result;
}

std::vector<std::string> mechanism_names() {
  std::vector<std::string> names;
  for (const problems::Mechanism& mechanism : problems::mechanisms()) {
    names.push_back(mechanism.name);
  }
  return names;
}

}  // namespace

nb::dict dict_of(const optim::LimitReport& limit) {
  nb::dict row;
  row["name"] = limit.name;
  row["value"] = limit.value;
  row["bound"] = limit.bound;
  row["side"] = limit.is_upper ? "upper" : "lower";
  row["margin"] = limit.margin;
  row["unit"] = limit.unit;
  row["at"] = limit.worst_angle ? nb::object(nb::cast(*limit.worst_angle)) : nb::none();
  row["met"] = limit.met;
  row["proved"] = limit.proved;
  row["tolerance"] = limit.tolerance;
  row["multiplier"] = limit.multiplier;
  return row;
}

nb::list list_of(const std::vector<optim::LimitReport>& limits) {
  nb::list rows;
  for (const optim::LimitReport& limit : limits) rows.append(dict_of(limit));
  return rows;
}

nb::dict curves_of(const ProblemStatement& statement, int count) {
  std::vector<double> places;
  std::vector<std::pair<std::string, std::vector<double>>> columns;
  {
    const nb::gil_scoped_release released;
    const std::vector<optim::Response> curves = problems::curves_of(statement);
    if (!curves.empty()) {
      const auto breaks = curves.front().curve().trace({})->breaks();
      const auto where = optim::even_places(breaks.front(), breaks.back(), count);
      for (const optim::Place& place : where) places.push_back(place.angle);
      for (const optim::Response& curve : curves) {
        columns.emplace_back(curve.name + " [" + curve.unit + "]",
                             curve.curve().trace({})->values(where));
      }
    }
  }
  nb::dict result;
  if (columns.empty()) return result;
  result[nb::cast(problems::place_name(statement))] = array_of(std::move(places));
  for (auto& [name, values] : columns) result[nb::cast(name)] = array_of(std::move(values));
  return result;
}

void add_problems(nb::module_& module) {
  nb::class_<StatedProblem>(module, "Problem")
      .def_prop_ro("text", [](const StatedProblem& p) { return p.statement.text; })
      .def_prop_ro("source", [](const StatedProblem& p) { return p.statement.source; })
      .def_prop_ro("title", [](const StatedProblem& p) { return p.statement.title; })
      .def_prop_ro("settings", [](const StatedProblem& p) { return p.statement.settings; })
      .def_prop_ro("mechanism", [](const StatedProblem& p) { return p.statement.mechanism->name; })
      .def("laws",
           [](const StatedProblem& p) {
             std::vector<std::string> names;
             for (const Member& law : p.statement.laws) names.push_back(law.name());
             return names;
           })
      .def("law",
           [](const StatedProblem& p) -> std::optional<NamedLaw> {
             if (p.statement.laws.empty() ||
                 p.statement.mechanism->moved_by == problems::MovedBy::Nothing) {
               return std::nullopt;
             }
             return NamedLaw(p.statement.laws.front().listed());
           })
      .def("with_settings", &problem_with, nb::arg("settings"))
      .def("variables", &variables_of)
      .def("constants", &constants_of)
      .def("objectives", &objectives_of)
      .def("constraints", &constraints_of)
      .def("check_derivatives", &checked_derivatives)
      .def("scaling", &scaling_of)
      .def("formula",
           [](const StatedProblem& p, const std::string& response) {
             return formula_of(*p.statement.mechanism, response);
           })
      .def("machine", [](const StatedProblem& p) { return dict_of(*p.statement.mechanism); })
      .def("evaluate", &evaluated)
      .def("check",
           [](const StatedProblem& p) {
             const cli::Document document =
                 cli::checked_problem(p.statement, {}, p.statement.source).document;
             return nb::make_tuple(python_of(cli::json_of(document)), plain(cli::text_of(document)),
                                   html_of(document));
           })
      .def(
          "curves", [](const StatedProblem& p, int count) { return curves_of(p.statement, count); },
          nb::arg("count"))
      .def("curves_figure",
           [](const StatedProblem& p) { return dict_of(cli::curves_figure(p.statement)); })
      .def("profile_figure",
           [](const StatedProblem& p) { return dict_of(cli::profile_figure(p.statement)); });
  module.def("problem", &problem_of_text, nb::arg("text"), nb::arg("source"));
  module.def(
      "problem_file",
      [](const std::string& path) { return StatedProblem{problems::read_problem_file(path)}; },
      nb::arg("path"));
  module.def("mechanism_names", &mechanism_names);
  module.def("formula", [](const std::string& mechanism, const std::string& response) {
    return formula_of(problems::find_mechanism(mechanism), response);
  });
  module.def("mechanism",
             [](const std::string& name) { return dict_of(problems::find_mechanism(name)); });
}

}  // namespace camlaw::python
