// SPDX-License-Identifier: MIT
#include "problems/tolerance/varied_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "machines/model/given_law.h"
#include "numerics/text/units.h"
#include "optim/search/interruptible.h"
#include "problems/statement/bind.h"
#include "problems/statement/cases.h"
#include "problems/statement/ranges.h"

namespace camlaw::problems {
namespace {

Binding varied_binding(const ProblemStatement& design,
                       const std::vector<VariationStatement>& variations) {
  Binding binding;
  binding.constants = design.constants;
  std::vector<std::pair<std::size_t, std::size_t>> varying;
  std::vector<LawVariable> of_law;
  for (std::size_t i = 0; i < variations.size(); ++i) {
    const NamedParameter& p = variations[i].parameter;
    if (p.of_law) {
      const auto own = index_in(*design.laws.front().family, p.law_parameter);
      if (!own) {
        throw std::invalid_argument("the law that was chosen has no " + p.name +
                                    ", which has a variation");
      }
      of_law.push_back({*own, variations[i].index, i});
    } else {
      varying.emplace_back(p.parameter, i);
    }
  }
  std::sort(varying.begin(), varying.end());
  for (const auto& [parameter, variable] : varying) {
    binding.parameters.push_back(parameter);
    binding.variables.push_back(variable);
  }
  binding.law = given_law(design.laws.front(), std::move(of_law), binding);
  return binding;
}

/// The design with limits and objectives of one part: over its ranges, but not over what
/// manufacture does.
ProblemStatement of_one_part(const ProblemStatement& problem) {
  ProblemStatement result = problem;
  result.variation = nullptr;
  result.constraints.clear();
  for (const ConstraintStatement& whole : problem.constraints) {
    for (ConstraintStatement& limit : of_one_value(result, whole)) {
      const MechanismResponse* response = limit.response.response;
      if (response != nullptr && response->over_ranges) {
        limit.of_range = response->over_ranges->of;
        limit.response.response = limit.of_range.get();
      }
      const bool is_over = is_quantile(whole) || (response != nullptr && response->over_ranges);
      if (is_over) limit = over_ranges(result, limit).front();  // it has one side
      result.constraints.push_back(std::move(limit));
    }
  }
  for (ObjectiveStatement& objective : result.objectives) {
    if (objective.over) {
      objective.response = objective.one_case;
      objective = over_cases(result, objective, *objective.over);
    } else if (objective.of_ranges) {
      objective.response = objective.one_value;
      objective = over_ranges(result, objective);
    }
  }
  return result;
}

}  // namespace

bool VariedDesign::varies_law() const {
  return std::any_of(statements.begin(), statements.end(),
                     [](const VariationStatement& v) { return v.parameter.of_law; });
}

std::vector<VariationStatement> asked_variations(const ProblemStatement& design,
                                                 const std::vector<std::string>& tolerances) {
  if (tolerances.empty()) return variations_of(design);
  std::vector<VariationStatement> result;
  for (const std::string& assignment : tolerances) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
      throw std::invalid_argument(fmt::format(
          "tolerance: '{}' is not of the form name=value, such as base_radius='0.05 mm'",
          assignment));
    }
    VariationStatement v;
    v.parameter = find_parameter(design, assignment.substr(0, equals));
    const std::string what = "tolerance " + v.parameter.name;
    const auto said = [](const auto& check) {
      try {
        check();
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("tolerance: {}", error.what()));
      }
    };
    said([&] { check_may_vary(design, v.parameter); });
    v.index = v.parameter.element.value_or(0);
    const std::string& unit = v.parameter.unit;
    const double value = parse_quantity(assignment.substr(equals + 1), unit, unit, what);
    if (!(value > 0 && std::isfinite(value))) {
      throw std::invalid_argument(what + ": it must be a number above 0");
    }
    v.plus = v.minus = value;
    said([&] { add_variation(result, std::move(v)); });
  }
  return result;
}

VariedDesign varied_design(const ProblemStatement& design,
                           std::vector<VariationStatement> variations,
                           const optim::Deadline& deadline) {
  if (variations.empty()) {
    throw std::invalid_argument(
        "no variation is stated; give [variation.base_radius] with plus and minus, or "
        "--tolerance base_radius='0.05 mm'");
  }
  VariedDesign result;
  result.design = of_one_part(design);
  result.statements = std::move(variations);
  result.deadline = deadline;
  for (const VariationStatement& v : result.statements) {
    check_variation(design, v);
    const double value = meant_value(design, v);
    result.meant.push_back(value);
    result.variations.push_back(v.at(value));
    // What manufacture does to it is its typical change: by any other, tolerances of limits would
    // grow with the slope and the unit, and pass over what the variation does.
    const double half = result.variations.back().half();
    result.problem.variables.push_back({.name = v.name(),
                                        .unit = v.parameter.unit,
                                        .start = value,
                                        .scale = half > 0 ? std::optional(half) : std::nullopt});
  }
  result.binding = varied_binding(design, result.statements);
  result.problem.name = design.title;
  for (const ObjectiveStatement& o : result.design.objectives) {
    result.problem.objectives.push_back({response_of(result.design, o.response, result.binding),
                                         o.sense, o.response.part, o.tolerance});
  }
  result.problem.constraints = constraints_of(result.design, result.binding);
  result.problem = optim::interruptible(std::move(result.problem), deadline);
  return result;
}

}  // namespace camlaw::problems
