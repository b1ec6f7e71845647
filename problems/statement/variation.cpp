// SPDX-License-Identifier: MIT
#include "problems/statement/variation.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "machines/model/load_case.h"

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
  check_variation_at(variation, value, variation.at(value));
}

void check_variation_at(const VariationStatement& variation, double value,
                        const optim::Variation& off) {
  for (const double end : {value + off.lower, value + off.upper}) {
    if (const auto why = refusal(variation.parameter, end)) {
      throw std::invalid_argument(fmt::format("{} is {}, and its variation reaches {}: {}",
                                              variation.name(),
                                              with_unit(value, variation.parameter.unit),
                                              with_unit(end, variation.parameter.unit), *why));
    }
  }
}

void check_may_vary(const ProblemStatement& problem, const NamedParameter& p) {
  const auto fail = [](const std::string& why) { throw std::invalid_argument(why); };
  if (p.list && !p.element) {
    fail(fmt::format("{} is a list; name one number of it, such as {}[1]", p.name, p.name));
  }
  if (p.integer || p.structural) {
    fail(fmt::format("{} is an integer, which has no variation", p.name));
  }
  if (p.of_law) return;
  if (problem.told_by_motion.contains(p.parameter)) {
    fail(fmt::format("the motion is stated in {}, so {} has one value", p.unit, p.name));
  }
  for (const ParameterRange& range : problem.ranges) {
    if (range.parameter != p.parameter) continue;
    fail(fmt::format("{} has a range, [ranges.{}]; drop one of the two", p.name, p.name));
  }
  for (const LoadCase& load : problem.cases) {
    const bool is_set = std::any_of(load.parameters.begin(), load.parameters.end(),
                                    [&](const auto& set) { return set.first == p.parameter; });
    if (is_set) fail(fmt::format("the load cases set {}; drop one of the two", p.name));
  }
}

void add_variation(std::vector<VariationStatement>& all, VariationStatement variation) {
  constexpr std::size_t kMost = 8;  // the worst part is sought at all 256 corners first
  for (const VariationStatement& other : all) {
    if (other.name() != variation.name()) continue;
    throw std::invalid_argument(
        fmt::format("this variation is stated twice: that of {}", other.name()));
  }
  if (all.size() == kMost) {
    throw std::invalid_argument(fmt::format("at most {} variations are accepted", kMost));
  }
  all.push_back(std::move(variation));
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
