// SPDX-License-Identifier: MIT
#include "machines/model/response_text.h"

#include <fmt/format.h>

#include <stdexcept>

#include "machines/model/recorded_response.h"
#include "numerics/formula/expression.h"
#include "numerics/formula/formula_lines.h"
#include "numerics/formula/unit_factor.h"
#include "numerics/text/dimension.h"

namespace camlaw::problems {
namespace {

/// Whether a step multiplies by this constant.
bool scales_by(const std::vector<Step>& steps, const Step& step, double factor) {
  return step.operation == Operation::Multiply && steps[step.a].operation == Operation::Constant &&
         steps[step.a].value == factor;
}

}  // namespace

std::string formula_text(const Mechanism& mechanism, const MechanismResponse& response) {
  if (!response.write) {
    throw std::invalid_argument(
        fmt::format("{}: {} is not one formula: it is integrated over the cycle", mechanism.name,
                    response.name));
  }
  const std::size_t parameters = mechanism.parameters.size();
  const std::vector<std::string> others = other_names(response);
  const Formula formula = whole_formula(response.write, parameters, others.size());
  const auto& steps = formula.steps();
  // A parameter in the units of the SI is its number in listed units times their size.
  const NameOfStep name_of = [&](const Step& step) -> std::optional<std::string> {
    if (step.operation == Operation::Input) {
      return step.a < parameters ? mechanism.parameters[step.a].name : others[step.a - parameters];
    }
    const bool may_be = step.operation == Operation::Multiply &&
                        steps[step.b].operation == Operation::Input && steps[step.b].a < parameters;
    if (!may_be) return {};
    const MechanismParameter& p = mechanism.parameters[steps[step.b].a];
    return scales_by(steps, step, UnitFactor(p.unit, p.stored).as<double>()) ? std::optional(p.name)
                                                                             : std::nullopt;
  };
  auto value = static_cast<std::uint32_t>(steps.size() - 1);
  const UnitFactor from_si(si_unit(response.unit).unit, response.unit);
  if (scales_by(steps, steps[value], from_si.as<double>())) value = steps[value].b;
  std::string text;
  for (const FormulaLines::Line& line : lines_of(formula, value, name_of).lines) {
    text += fmt::format("{} = {}\n", line.name.empty() ? response.name : line.name, line.text);
  }
  return text;
}

}  // namespace camlaw::problems
