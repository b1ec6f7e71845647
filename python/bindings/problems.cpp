// SPDX-License-Identifier: MIT
#include "python/bindings/problems.h"

#include <fmt/format.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "optim/cycle/proof_time.h"
#include "output/answers/buildable_output.h"
#include "output/answers/check_output.h"
#include "output/answers/cycle_figure.h"
#include "output/answers/limit_text.h"
#include "output/answers/possible.h"
#include "output/answers/warnings.h"
#include "output/document/printing.h"
#include "output/figure/profile_figure.h"
#include "output/report/html.h"
#include "problems/law_files/law_file.h"
#include "problems/results/input_files.h"
#include "problems/results/start_settings.h"
#include "problems/statement/buildable.h"
#include "problems/statement/default_machine.h"
#include "problems/statement/held_files.h"
#include "problems/statement/parameters.h"
#include "problems/statement/problem_format.h"
#include "problems/statement/shipped_files.h"
#include "python/bindings/laws.h"
#include "python/bindings/mechanisms.h"
#include "python/bindings/module.h"
#include "python/bindings/problem_state.h"
#include "python/bindings/running.h"

namespace camlaw::python {
namespace {

using problems::EvaluatedResponse;
using problems::ProblemStatement;

/// `laws`: those that the text names as files without there being any.
StatedProblem problem_of_text(const std::string& text, const std::string& source,
                              const std::map<std::string, const MemberLaw*>& laws) {
  const Unlocked released;
  problems::HeldFiles files;
  for (const auto& [name, law] : laws) {
    const std::string file = problems::law_text(law->law, law->member.label());
    files.laws.emplace(name, problems::read_law_text(file, name));
  }
  return {problems::read_problem(text, source, std::move(files))};
}

/// The files that a problem's text names, as texts by these names.
std::map<std::string, std::string> held_files(const StatedProblem& problem) {
  const Unlocked released;
  std::map<std::string, std::string> texts = problem.statement.files.tables;
  for (const auto& [name, law] : problem.statement.files.laws) {
    texts.emplace(name, problems::law_text(law.law(), law.label()));
  }
  return texts;
}

StatedProblem problem_file(const std::string& path) {
  const Unlocked released;
  return {problems::read_problem_file(path)};
}

StatedProblem problem_with(const StatedProblem& problem, const std::vector<std::string>& settings) {
  const Unlocked released;
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
struct Evaluated {
  std::vector<EvaluatedResponse> responses;
  cli::SidedLimits sided;
  std::vector<problems::Json> worst_at;                 ///< of each limit (cli::worst_at_json)
  std::vector<problems::Json> why_no_value;             ///< of each limit (why_no_value_json)
  std::vector<problems::Json> undecided;                ///< of each limit (cli::undecided_json)
  std::vector<problems::Json> why_not_proved;           ///< of each limit (why_not_proved_json)
  std::vector<problems::Json> other_side;               ///< of each limit (cli::side_json), or null
  std::vector<std::optional<std::string>> required_by;  ///< of each limit (ConstraintStatement)
  problems::Buildability built;
  cli::Warnings warnings;
  std::string cut_short;  ///< why proofs ended early; empty where none did
};

/// `time_limit`: seconds after which proofs end.
nb::dict evaluated(const StatedProblem& problem, std::optional<double> time_limit) {
  const optim::Deadline deadline(time_limit, nullptr);
  const Evaluated found = run_whole([&](const Work& work) {
    const ProblemStatement statement = problem.within(work);
    const optim::ProofTime proof_time(deadline);
    Evaluated all;
    all.responses = problems::evaluate(statement);
    cli::check_possible(statement.source, statement, all.responses);
    all.sided = cli::both_sides(statement, problems::standing(statement));
    for (std::size_t i = 0; i < statement.constraints.size(); ++i) {
      const auto& limit = statement.constraints[i];
      const auto& other = all.sided.others[i];
      all.worst_at.push_back(
          cli::worst_at_json(statement, limit.response, all.sided.limits[i].worst_angle));
      all.why_no_value.push_back(cli::why_no_value_json(all.sided.limits[i], statement, i));
      all.undecided.push_back(cli::undecided_json(all.sided.limits[i], statement, i));
      all.why_not_proved.push_back(cli::why_not_proved_json(all.sided.limits[i], statement, i));
      all.other_side.push_back(other ? cli::side_json(*other, statement, i) : nullptr);
      all.required_by.push_back(limit.required_by);
    }
    all.built = problems::buildability(statement);
    all.warnings = cli::warnings_of(statement);
    if (proof_time.has_ended_any()) all.cut_short = deadline.reason();
    return all;
  });
  nb::list rows;
  for (const EvaluatedResponse& response : found.responses) rows.append(dict_of(response));
  nb::dict result;
  result["responses"] = rows;
  nb::list limits = list_of(found.sided.limits);
  for (std::size_t i = 0; i < found.required_by.size(); ++i) {
    nb::dict limit = nb::cast<nb::dict>(limits[i]);
    const auto& by = found.required_by[i];
    limit["worst_at"] = python_of(found.worst_at[i]);
    limit["why_no_value"] = python_of(found.why_no_value[i]);
    limit["undecided"] = python_of(found.undecided[i]);
    limit["why_not_proved"] = python_of(found.why_not_proved[i]);
    limit["other_side"] = python_of(found.other_side[i]);
    limit["required_by"] = by ? nb::object(nb::cast(*by)) : nb::none();
  }
  result["limits"] = limits;
  result["buildable"] = python_of(cli::buildable_json(found.built));
  result["warnings"] = found.warnings;
  result["cut_short"] = found.cut_short;
  return result;
}

/// Every derivative against differences: of each law to choose from, and each objective.
nb::list checked_derivatives(const StatedProblem& stated) {
  const auto variants =
      run_whole([&](const Work& work) { return cli::checked_derivatives(stated.within(work)); });
  nb::list result;
  for (const cli::CheckedVariant& variant : variants) {
    const optim::DerivativeCheck& found = variant.found;
    nb::dict row;
    row["problem"] = variant.objective + (variant.law.empty() ? "" : ", law " + variant.law);
    row["derivatives"] = found.entries;
    row["agrees"] = found.agrees && found.shapes.empty();
    row["worst_error"] = found.worst.error;
    row["response"] = found.worst.response;
    row["variable"] = found.worst.variable;
    row["second"] = found.worst.second;
    row["shapes"] = found.shapes;
    result.append(row);
  }
  return result;
}

/// What variables and limits are divided by, and their tolerances.
nb::object scaling_of(const StatedProblem& stated) {
  return python_of(cli::json_of(
      run_whole([&](const Work& work) { return cli::scaling_of(stated.within(work)); })));
}

/// The problem said back, as facts, text and HTML.
nb::tuple said_back(const StatedProblem& stated) {
  const cli::Document document = run_whole([&](const Work& work) {
    return cli::checked_problem(stated.within(work), {}, stated.statement.source).document;
  });
  return nb::make_tuple(python_of(cli::json_of(document)), cli::unshaded(cli::text_of(document)),
                        cli::html_of(document));
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

nb::dict curves_of(const StatedProblem& problem, int count) {
  using Columns = std::vector<std::pair<std::string, std::vector<double>>>;
  Columns columns = run_whole([&](const Work& work) {
    const ProblemStatement statement = problem.within(work);
    Columns result;
    const std::vector<optim::Response> curves = problems::curves_of(statement);
    if (curves.empty()) return result;
    const auto breaks = curves.front().curve().trace({})->breaks();
    const auto where = optim::even_places(breaks.front(), breaks.back(), count);
    std::vector<double> places;
    for (const optim::Place& place : where) places.push_back(place.angle);
    result.emplace_back(problems::place_name(statement), std::move(places));
    for (const optim::Response& curve : curves) {
      result.emplace_back(curve.name + " [" + curve.unit + "]",
                          curve.curve().trace({})->values(where));
    }
    return result;
  });
  nb::dict result;
  for (auto& [name, values] : columns) result[nb::cast(name)] = array_of(std::move(values));
  return result;
}

void add_problems(nb::module_& module) {
  nb::class_<StatedProblem>(module, "Problem")
      .def_prop_ro("text", [](const StatedProblem& p) { return p.statement.text; })
      .def_prop_ro("source", [](const StatedProblem& p) { return p.statement.source; })
      .def("is_input",
           [](const StatedProblem& p, const std::string& path) {
             return without_lock([&] { return problems::is_read_by({p.statement, ""}, path); });
           })
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
           [](const StatedProblem& p) -> std::optional<MemberLaw> {
             if (p.statement.laws.empty() || !p.statement.mechanism->cams.empty() ||
                 p.statement.mechanism->moved_by == problems::MovedBy::Nothing) {
               return std::nullopt;
             }
             return MemberLaw(p.statement.laws.front().listed());
           })
      .def("held_files", &held_files)
      .def("found_settings",
           [](const StatedProblem& p) {
             return without_lock([&] { return problems::restated_settings(p.statement); });
           })
      .def("with_settings", &problem_with, nb::arg("settings"))
      .def("variables", &variables_of)
      .def(
          "unit_of",
          [](const StatedProblem& p, const std::string& name) {
            return without_lock([&] { return problems::find_parameter(p.statement, name).unit; });
          },
          nb::arg("name"))
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
      .def("evaluate", &evaluated, nb::arg("time_limit").none())
      .def("check", &said_back)
      .def("curves", &curves_of, nb::arg("count"))
      .def("curves_figure",
           [](const StatedProblem& p) {
             return dict_of(
                 run_whole([&](const Work& work) { return cli::curves_figure(p.within(work)); }));
           })
      .def("profile_figure",
           [](const StatedProblem& p) {
             return dict_of(
                 run_whole([&](const Work& work) { return cli::profile_figure(p.within(work)); }));
           })
      .def("curves_svg",
           [](const StatedProblem& p) {
             return run_whole(
                 [&](const Work& work) { return cli::to_svg(cli::curves_figure(p.within(work))); });
           })
      .def("profile_svg",
           [](const StatedProblem& p) {
             return run_whole([&](const Work& work) {
               return cli::to_svg(cli::profile_figure(p.within(work)));
             });
           })
      .def("__getstate__", &problem_state_of)
      .def("__setstate__", [](StatedProblem& problem, const ProblemState& state) {
        new (&problem) StatedProblem(problem_of(state));
      });
  module.attr("problem_format") = problems::kProblemFormat.text();
  module.def("problem", &problem_of_text, nb::arg("text"), nb::arg("source"),
             nb::arg("laws") = std::map<std::string, const MemberLaw*>{});
  module.def("problem_file", &problem_file, nb::arg("path"));
  module.def(
      "example",
      [](const std::string& name) {
        return problem_file(problems::find_shipped(name).path.string());
      },
      nb::arg("name"));
}

}  // namespace camlaw::python
