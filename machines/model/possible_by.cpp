// SPDX-License-Identifier: MIT
#include "machines/model/possible_by.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <set>

#include "machines/model/arguments.h"
#include "machines/model/possibility.h"
#include "machines/model/recorded_kernel.h"
#include "machines/model/recorded_response.h"
#include "machines/model/shape_rules.h"
#include "numerics/formula/expression.h"
#include "optim/problem/widest_side.h"

namespace camlaw::problems {

using optim::Bounds;

namespace {

/// Whether a condition holds wherever its margin lies within these bounds.
bool holds_within(const Interval& margin, bool may_be_zero) {
  return margin.lower() > 0 || (may_be_zero && margin.lower() == 0);
}

/// What the varying parameters of a binding accept.
std::vector<Interval> accepted(const Margin& margin, const Binding& binding) {
  std::vector<Interval> box;
  for (const std::size_t i : binding.parameters) box.push_back(margin.accepted(i));
  return box;
}

/// The binding in which these parameters vary too.
Binding with_varying(const Binding& binding, const ParameterSet& parameters) {
  Binding result = binding;
  result.parameters.insert(result.parameters.end(), parameters.begin(), parameters.end());
  std::sort(result.parameters.begin(), result.parameters.end());
  result.parameters.erase(std::unique(result.parameters.begin(), result.parameters.end()),
                          result.parameters.end());
  return result;
}

/// The margins that decide, each of which depends on something that varies.
template <class Visit>
void for_deciding(const std::vector<Margin>& margins, const Binding& binding, const Visit& visit) {
  for (const Margin& margin : margins) {
    const Formula formula = recorded_for(binding, margin.write, 0, {}).formula;
    if (formula.uses().empty()) continue;
    const std::vector<Interval> box = accepted(margin, binding);
    const Interval value = formula(std::span<const Interval>(box));
    if (!holds_within(value, margin.may_be_zero)) visit(formula, box);
  }
}

std::vector<std::size_t> deciding_of(const std::vector<Margin>& margins, const Binding& binding) {
  std::set<std::size_t> found;
  for_deciding(margins, binding, [&](const Formula& margin, const auto&) {
    for (const std::size_t k : margin.uses()) found.insert(binding.parameters[k]);
  });
  return {found.begin(), found.end()};
}

/// A part of a box, by the least that a margin may be there.
struct OpenPart {
  std::vector<Bounds> box;
  double least;
  bool operator<(const OpenPart& other) const { return least > other.least; }
};

std::vector<double> middle_of(const std::vector<Bounds>& box) {
  std::vector<double> middle;
  for (const Bounds& b : box) middle.push_back(std::midpoint(b.lower, b.upper));
  return middle;
}

/// The corners of a box in these inputs, the others in their middles; none where they are many.
std::vector<std::vector<double>> corners_of(std::span<const Bounds> box,
                                            const std::vector<std::size_t>& inputs) {
  constexpr std::size_t kMost = 6;
  std::vector<std::vector<double>> all{middle_of({box.begin(), box.end()})};
  if (inputs.size() > kMost) return {};
  for (const std::size_t i : inputs) {
    const std::size_t count = all.size();
    for (std::size_t k = 0; k < count; ++k) {
      all[k][i] = box[i].lower;
      all.push_back(all[k]);
      all.back()[i] = box[i].upper;
    }
  }
  return all;
}

/// Looks at one condition all over a box, which is halved where its bounds leave open whether it
/// holds: first where its margin may be least. So it comes to the least margin as a search for a
/// root does, however narrow the place at which the condition fails.
MachinesOfBox looked_at(const Formula& margin, bool may_be_zero, std::span<const Bounds> whole) {
  constexpr int kParts = 2000;  // parts, each one enclosure: a proof that needs more is given up
  std::priority_queue<OpenPart> open;
  std::optional<std::vector<double>> fails;
  const auto look = [&](std::vector<Bounds> box) {
    std::vector<Interval> within;
    for (const Bounds& b : box) within.emplace_back(b.lower, b.upper);
    const Interval value = margin(std::span<const Interval>(within));
    if (holds_within(value, may_be_zero)) return;
    std::vector<double> middle = middle_of(box);
    if (!margin_holds(margin(std::span<const double>(middle)), may_be_zero))
      fails = std::move(middle);
    const double least = std::isnan(value.lower()) ? -optim::kInfinity : value.lower();
    open.push({std::move(box), least});
  };
  for (std::vector<double>& corner : corners_of(whole, margin.uses())) {
    if (!margin_holds(margin(std::span<const double>(corner)), may_be_zero)) return {false, corner};
  }
  look({whole.begin(), whole.end()});
  for (int parts = 0; !fails && !open.empty(); ++parts) {
    if (parts >= kParts) return {false, {}};
    const std::vector<Bounds> box = open.top().box;
    open.pop();
    const auto halved = optim::widest_side(box, whole, margin.uses());
    if (!halved) continue;  // a single machine, which is possible
    const double middle = std::midpoint(box[*halved].lower, box[*halved].upper);
    if (!(middle > box[*halved].lower && middle < box[*halved].upper)) return {false, {}};
    for (const bool is_upper : {false, true}) {
      std::vector<Bounds> half = box;
      (is_upper ? half[*halved].lower : half[*halved].upper) = middle;
      look(std::move(half));
    }
  }
  return fails ? MachinesOfBox{false, std::move(*fails)} : MachinesOfBox{};
}

/// A binding in which all parameters vary; its constants do not matter.
Binding of_all(std::size_t parameters) {
  Binding binding;
  binding.constants.resize(parameters);
  for (std::size_t i = 0; i < parameters; ++i) {
    binding.parameters.push_back(i);
    binding.variables.push_back(i);
  }
  return binding;
}

}  // namespace

PossibleBy possible_by(std::vector<Margin> margins, std::size_t parameters) {
  PossibleBy result;
  result.margins = margins;
  if (margins.empty()) return result;
  result.parameters = ParameterSet([margins = std::move(margins), parameters] {
    return deciding_of(margins, of_all(parameters));
  });
  return result;
}

PossibleBy united(std::vector<PossibleBy> all) {
  PossibleBy result;
  std::vector<ParameterSet> parameters, ranges;
  for (PossibleBy& one : all) {
    parameters.push_back(one.parameters);
    ranges.push_back(one.ranges);
    std::move(one.margins.begin(), one.margins.end(), std::back_inserter(result.margins));
  }
  result.parameters = united(std::move(parameters));
  result.ranges = united(std::move(ranges));
  return result;
}

bool may_decide(const PossibleBy& possible_by, const Binding& binding) {
  return std::any_of(binding.parameters.begin(), binding.parameters.end(),
                     [&](std::size_t parameter) { return possible_by.holds(parameter); });
}

std::vector<std::size_t> deciding(const PossibleBy& possible_by, const Binding& binding) {
  if (!may_decide(possible_by, binding)) return {};
  std::vector<std::size_t> found =
      deciding_of(possible_by.margins, with_varying(binding, possible_by.ranges));
  std::erase_if(found, [&](std::size_t parameter) {
    return !std::binary_search(binding.parameters.begin(), binding.parameters.end(), parameter);
  });
  return found;
}

bool is_convex_by_rules(const PossibleBy& possible_by, const Binding& binding) {
  if (!may_decide(possible_by, binding)) return true;
  bool is_convex = true;
  const Binding whole = with_varying(binding, possible_by.ranges);
  for_deciding(possible_by.margins, whole, [&](const Formula& margin, const auto& box) {
    std::vector<RuledInput> inputs;
    for (std::size_t k = 0; k < box.size(); ++k) {
      const bool varies = std::binary_search(binding.parameters.begin(), binding.parameters.end(),
                                             whole.parameters[k]);
      inputs.push_back({varies ? Varies::Linearly : Varies::Not, box[k]});
    }
    is_convex &= optim::convex_above(shape_by_rules(margin, inputs).shape);
  });
  return is_convex;
}

std::vector<optim::Function> margin_functions(const PossibleBy& possible_by,
                                              const Binding& binding) {
  std::vector<optim::Function> functions;
  for (const Margin& margin : possible_by.margins) {
    const Formula formula = recorded_for(binding, margin.write, 0, {}).formula;
    if (!formula.uses().empty()) continue;
    const std::vector<Interval> box = accepted(margin, binding);
    if (holds_within(formula(std::span<const Interval>(box)), margin.may_be_zero)) continue;
    functions.push_back(function_of(binding.variables, recorded_kernel({formula, box.size(), {}}),
                                    optim::Shape::General));
  }
  std::vector<Formula> seen;  // load cases may have the same
  if (!may_decide(possible_by, binding)) return functions;
  for_deciding(possible_by.margins, binding, [&](const Formula& margin, const auto& box) {
    const bool is_known = std::any_of(seen.begin(), seen.end(), [&](const Formula& other) {
      return other.steps() == margin.steps();
    });
    if (is_known) return;
    seen.push_back(margin);
    functions.push_back(function_of(binding.variables, recorded_kernel({margin, box.size(), {}}),
                                    optim::Shape::General));
  });
  return functions;
}

RecordedMargins::RecordedMargins(const PossibleBy& possible_by, const Binding& binding) {
  for (const Margin& margin : possible_by.margins) {
    Formula formula = recorded_for(binding, margin.write, 0, {}).formula;
    if (formula.uses().empty()) continue;
    margins_.push_back({std::move(formula), margin.may_be_zero});
  }
}

MachinesOfBox RecordedMargins::over(std::span<const Bounds> box) const {
  MachinesOfBox result;
  for (const Recorded& margin : margins_) {
    MachinesOfBox of_one = looked_at(margin.formula, margin.may_be_zero, box);
    if (!of_one.impossible.empty()) return of_one;
    result.all_possible &= of_one.all_possible;
  }
  return result;
}

}  // namespace camlaw::problems
