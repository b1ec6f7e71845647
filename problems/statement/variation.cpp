// SPDX-License-Identifier: MIT
#include "problems/statement/variation.h"

#include <fmt/format.h>

#include <stdexcept>

namespace camlaw::problems {

optim::Variation VariationStatement::at(double value) const {
  if (!fit) return {-minus, plus, is_normal};
  const FitDeviations off = fit_deviations(*fit, of_diameter ? 2 * value : value);
  const double share = of_diameter ? 0.5 : 1;
  return {share * off.lower, share * off.upper, is_normal};
}

const std::vector<VariationStatement>& variations_of(const ProblemStatement& problem) {
  static const std::vector<VariationStatement> none;
  return problem.variation ? problem.variation->all : none;
}

double meant_value(const ProblemStatement& problem, const VariationStatement& variation) {
  return values_of(problem, variation.parameter).at(variation.index);
}

void check_variation(const ProblemStatement& problem, const VariationStatement& variation) {
  const double value = meant_value(problem, variation);
  const optim::Variation off = variation.at(value);
  for (const double end : {value + off.lower, value + off.upper}) {
    if (const auto why = refusal(variation.parameter, end)) {
      throw std::invalid_argument(fmt::format("{} is {}, and its variation reaches {}: {}",
                                              variation.name(),
                                              with_unit(value, variation.parameter.unit),
                                              with_unit(end, variation.parameter.unit), *why));
    }
  }
}

std::string variation_text(const VariationStatement& variation, double value) {
  const optim::Variation off = variation.at(value);
  const std::string& unit = variation.parameter.unit;
  std::string text;
  if (variation.fit) {
    text = fmt::format("{}{}{}, ", variation.of_diameter ? "diameter " : "", variation.fit->letter,
                       variation.fit->grade);
  }
  if (off.lower == -off.upper) {
    text += fmt::format("+-{}", with_unit(off.upper, unit));
  } else {
    const auto side = [](double v) { return fmt::format("{:+.6g}", v + 0.0); };
    text += fmt::format("{}/{}{}", side(off.upper), side(off.lower), unit == "1" ? "" : " " + unit);
  }
  if (off.is_normal) {
    text += fmt::format(" (normal, deviation {})", with_unit(off.deviation(), unit));
  }
  return text;
}

}  // namespace camlaw::problems
