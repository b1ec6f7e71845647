// SPDX-License-Identifier: MIT
#include "machines/model/response_text.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "machines/model/recorded_response.h"
#include "numerics/formula/expression.h"
#include "numerics/formula/formula_latex.h"
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

/// The lines of a formula, the response's name before the last.
std::vector<FormulaLines::Line> response_lines(const Mechanism& mechanism,
                                               const MechanismResponse& response) {
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
  std::vector<FormulaLines::Line> lines = lines_of(formula, value, name_of).lines;
  lines.back().name = response.name;
  return lines;
}

/// A parameter by its symbol, the law's s, v, a, j as derivatives of s, t1, t2, ... with an index.
std::string latex_name(const Mechanism& mechanism, const std::string& name) {
  constexpr std::pair<std::string_view, const char*> kOfLaw[] = {
      {"s", "s"}, {"v", "s'"}, {"a", "s''"}, {"j", "s'''"}, {"x", "x"}, {"angle", "\\varphi"}};
  for (const auto& [ours, set] : kOfLaw) {
    if (name == ours) return set;
  }
  for (const MechanismParameter& p : mechanism.parameters) {
    if (p.name == name) return latex_symbol(p.symbol.empty() ? p.name : p.symbol);
  }
  const bool is_step = name.size() > 1 &&
                       std::string_view("tuy").find(name[0]) != std::string_view::npos &&
                       name.find_first_not_of("0123456789", 1) == std::string::npos;
  if (is_step || name == "pi") return latex_symbol(name);
  std::string words;
  for (const char c : name) words += c == '_' ? ' ' : c;
  return fmt::format("\\text{{{}}}", words);
}

}  // namespace

std::string formula_text(const Mechanism& mechanism, const MechanismResponse& response) {
  std::string text;
  for (const FormulaLines::Line& line : response_lines(mechanism, response)) {
    text += fmt::format("{} = {}\n", line.name, line.text);
  }
  return text;
}

std::string formula_latex(const Mechanism& mechanism, const MechanismResponse& response) {
  const auto set = [&](const std::string& name) { return latex_name(mechanism, name); };
  std::string text;
  for (const FormulaLines::Line& line : response_lines(mechanism, response)) {
    text += fmt::format("{}{} &= {}", text.empty() ? "" : " \\\\\n", set(line.name),
                        latex_of(parse_formula(line.text), set));
  }
  return fmt::format("\\begin{{aligned}}\n{}\n\\end{{aligned}}", text);
}

}  // namespace camlaw::problems
