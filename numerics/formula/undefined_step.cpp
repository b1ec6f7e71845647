// SPDX-License-Identifier: MIT
#include "numerics/formula/undefined_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

std::string words_of(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::Add:
      return fmt::format("it adds {:.6g} and {:.6g}", a, b);
    case Operation::Subtract:
      return fmt::format("it subtracts {:.6g} from {:.6g}", b, a);
    case Operation::Multiply:
      return fmt::format("it multiplies {:.6g} by {:.6g}", a, b);
    case Operation::Divide:
      return fmt::format("it divides {:.6g} by {:.6g}", a, b);
    case Operation::Sqrt:
      return fmt::format("it takes the square root of {:.6g}", a);
    case Operation::Sin:
    case Operation::Cos:
    case Operation::Tan:
      return fmt::format("it takes the {} of {:.6g}",
                         operation == Operation::Sin   ? "sine"
                         : operation == Operation::Cos ? "cosine"
                                                       : "tangent",
                         a);
    case Operation::Asin:
      return fmt::format("it takes the arcsine or arccosine of {:.6g}", a);
    case Operation::Log:
      return fmt::format("it takes the logarithm of {:.6g}", a);
    case Operation::Power:
      return fmt::format("it raises {:.6g} to the power of {:.6g}", a, b);
    case Operation::WherePositive:
      return fmt::format("it has a value where a number is above 0, which is {:.6g}", a);
    default:
      return {};
  }
}

/// The results of all steps.
std::vector<double> results_of(const std::vector<Step>& steps, std::span<const double> u) {
  std::vector<double> results;
  for (const Step& step : steps) {
    if (step.operation == Operation::Input) {
      results.push_back(u[step.a]);
    } else if (step.operation == Operation::Constant) {
      results.push_back(step.value);
    } else {
      const std::size_t count = operands(step.operation);
      const double a = count > 0 ? results[step.a] : 0, b = count > 1 ? results[step.b] : 0;
      results.push_back(operate(step.operation, a, b, count > 2 ? results[step.c] : 0));
    }
  }
  return results;
}

}  // namespace

std::string why_undefined(const Formula& formula, std::span<const double> u) {
  const std::vector<Step>& steps = formula.steps();
  const bool searches = std::ranges::any_of(
      steps, [](const Step& step) { return step.operation == Operation::Root; });
  if (searches || steps.empty()) return {};
  const std::vector<double> results = results_of(steps, u);
  std::size_t at = steps.size() - 1;
  if (!std::isnan(results[at])) return {};
  while (true) {
    const Step& step = steps[at];
    std::vector<std::uint32_t> taken{step.a, step.b, step.c};
    taken.resize(operands(step.operation));
    if (step.operation == Operation::BySide && !std::isnan(results[step.a])) {
      taken = {results[step.a] < 0 ? step.c : step.b};
    }
    const auto undefined =
        std::ranges::find_if(taken, [&](std::uint32_t k) { return std::isnan(results[k]); });
    if (undefined != taken.end()) {
      at = *undefined;
      continue;
    }
    const auto number = [&](std::size_t k) { return k < taken.size() ? results[taken[k]] : 0; };
    return words_of(step.operation, number(0), number(1));
  }
}

}  // namespace camlaw
