// SPDX-License-Identifier: MIT
#include "machines/model/possible_by.h"

#include <algorithm>
#include <set>

#include "machines/model/recorded_response.h"
#include "machines/model/shape_rules.h"
#include "numerics/formula/expression.h"

namespace camlaw::problems {

using optim::Bounds;

namespace {

/// A margin as a formula of what varies of a binding.
struct RecordedMargin {
  Formula formula;
  bool may_be_zero;

  std::vector<Interval> box_of(std::span<const Bounds> bounds) const {
    std::vector<Interval> box;
    for (const Bounds& b : bounds) box.emplace_back(b.lower, b.upper);
    return box;
  }
  /// What the margin lies between over a box.
  Interval over(std::span<const Interval> box) const { return formula(box); }
  bool holds_over(const Interval& margin) const {
    return margin.lower() > 0 || (may_be_zero && margin.lower() == 0);
  }
};

RecordedMargin recorded(const Margin& margin, const Binding& binding) {
  return {recorded_for(binding, margin.write, 0, {}).formula, margin.may_be_zero};
}

/// What the varying parameters of a binding accept.
std::vector<Interval> accepted(const Margin& margin, const Binding& binding) {
  std::vector<Interval> box;
  for (const std::size_t i : binding.parameters) box.push_back(margin.accepted(i));
  return box;
}

/// The margins that decide in a binding, each of which depends on something that varies.
template <class Visit>
void for_deciding(const std::vector<Margin>& margins, const Binding& binding, const Visit& visit) {
  for (const Margin& margin : margins) {
    const RecordedMargin record = recorded(margin, binding);
    if (record.formula.uses().empty()) continue;
    const std::vector<Interval> box = accepted(margin, binding);
    if (!record.holds_over(record.over(box))) visit(record, box);
  }
}

std::vector<std::size_t> deciding_of(const std::vector<Margin>& margins, const Binding& binding) {
  std::set<std::size_t> found;
  for_deciding(margins, binding, [&](const RecordedMargin& margin, const auto&) {
    for (const std::size_t k : margin.formula.uses()) found.insert(binding.parameters[k]);
  });
  return {found.begin(), found.end()};
}

/// Whether something varies that may decide. It spares a look at the margins.
bool may_decide(const PossibleBy& possible_by, const Binding& binding) {
  return std::any_of(binding.parameters.begin(), binding.parameters.end(),
                     [&](std::size_t parameter) { return possible_by.holds(parameter); });
}

/// The widest of these inputs in parts of its first width; none where none has a width.
std::optional<std::size_t> widest(const std::vector<Bounds>& box, std::span<const Bounds> whole,
                                  const std::vector<std::size_t>& inputs) {
  std::optional<std::size_t> found;
  double most = 0;
  for (const std::size_t i : inputs) {
    const double width = whole[i].upper - whole[i].lower;
    const double share = width > 0 ? (box[i].upper - box[i].lower) / width : 0;
    if (!(share > most)) continue;
    most = share;
    found = i;
  }
  return found;
}

/// Whether a condition holds all over a box, which is halved where its bounds leave that open.
bool holds_all_over(const RecordedMargin& margin, std::span<const Bounds> whole) {
  constexpr int kParts = 500;
  std::vector<std::vector<Bounds>> left{{whole.begin(), whole.end()}};
  for (int parts = 0; !left.empty(); ++parts) {
    const std::vector<Bounds> box = std::move(left.back());
    left.pop_back();
    const Interval value = margin.over(margin.box_of(box));
    if (margin.holds_over(value)) continue;
    const bool is_broken = value.upper() < 0 || (!margin.may_be_zero && value.upper() == 0);
    const auto halved = widest(box, whole, margin.formula.uses());
    if (is_broken || !halved || parts >= kParts) return false;
    const double middle = std::midpoint(box[*halved].lower, box[*halved].upper);
    for (const bool is_upper : {false, true}) {
      left.push_back(box);
      (is_upper ? left.back()[*halved].lower : left.back()[*halved].upper) = middle;
    }
  }
  return true;
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
  std::vector<ParameterSet> parameters;
  for (PossibleBy& one : all) {
    parameters.push_back(one.parameters);
    std::move(one.margins.begin(), one.margins.end(), std::back_inserter(result.margins));
  }
  result.parameters = united(std::move(parameters));
  return result;
}

std::vector<std::size_t> deciding(const PossibleBy& possible_by, const Binding& binding) {
  if (!may_decide(possible_by, binding)) return {};
  return deciding_of(possible_by.margins, binding);
}

bool is_convex_by_rules(const PossibleBy& possible_by, const Binding& binding) {
  if (!may_decide(possible_by, binding)) return true;
  bool is_convex = true;
  for_deciding(possible_by.margins, binding, [&](const RecordedMargin& margin, const auto& box) {
    std::vector<RuledInput> inputs;
    for (const Interval& range : box) inputs.push_back({Varies::Linearly, range});
    const optim::Shape shape = shape_by_rules(margin.formula, inputs).shape;
    is_convex &= shape == optim::Shape::Linear || shape == optim::Shape::Concave ||
                 shape == optim::Shape::Quasilinear || shape == optim::Shape::Quasiconcave;
  });
  return is_convex;
}

bool all_possible(const PossibleBy& possible_by, const Binding& binding,
                  std::span<const Bounds> box) {
  return std::all_of(possible_by.margins.begin(), possible_by.margins.end(),
                     [&](const Margin& margin) {
                       const RecordedMargin record = recorded(margin, binding);
                       return record.formula.uses().empty() || holds_all_over(record, box);
                     });
}

}  // namespace camlaw::problems
