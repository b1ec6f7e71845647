// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "machines/model/fixed_binding.h"
#include "machines/model/load_case.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/ranges.h"
#include "problems/statement/why_undefined.h"

namespace camlaw::problems {

namespace {

/// The binding of a design, in which nothing varies.
Binding whole_binding(const ProblemStatement& design) {
  return fixed_binding(design.constants, design.laws.front());
}

}  // namespace

std::vector<PlaceInRange> worst_in_ranges(const ProblemStatement& design, const ResponseName& of,
                                          const std::optional<double>& place) {
  if (of.response == nullptr || design.laws.empty()) return {};
  if (!of.response->over_cases.empty()) {
    const auto in = place ? place_in_case(of, *place) : std::nullopt;
    if (!in) return {};
    return worst_in_ranges(design, of.response->over_cases.at(in->part), in->place);
  }
  if (!of.response->over_ranges || (of.response->curve && !place)) return {};
  const Binding binding = whole_binding(design);
  const optim::Place at{place.value_or(0)};
  const OverRanges& over = *of.response->over_ranges;
  const std::vector<double> worst = over.worst(binding, {}, &at);
  std::vector<PlaceInRange> places;
  for (std::size_t i = 0; i < worst.size(); ++i) {
    if (std::isnan(worst[i])) continue;
    const MechanismParameter& p = design.mechanism->parameters[over.ranges[i].parameter];
    places.push_back({p.name, p.unit, worst[i]});
  }
  return places;
}

namespace {

/// Why a response of the mechanism has no value at a design; empty where that is not known, and
/// where it has one.
std::string why_undefined_there(const ProblemStatement& design, const MechanismResponse& of) {
  const ResponseName own = find_response(*design.mechanism, of.name);
  if (own.response == nullptr) return {};
  const EvaluatedResponse value = evaluate_response(design, *own.response);
  if (!std::isnan(value.is_curve ? value.highest : value.value)) return {};
  if (std::string why = why_undefined(design, value); !why.empty()) return why;
  // That a part is left out goes without saying only where nobody asks for what it does.
  return value.is_curve
             ? response_of(design, own, whole_binding(design)).curve().trace({})->why_unbounded()
             : std::string();
}

}  // namespace

std::string why_no_value(const ProblemStatement& design, const ResponseName& of,
                         const std::optional<double>& place) {
  if (of.response == nullptr) return {};
  if (!of.response->over_cases.empty()) {
    const auto in = place ? place_in_case(of, *place) : std::nullopt;
    if (!in) return {};
    return why_no_value(design, of.response->over_cases.at(in->part), in->place);
  }
  const std::vector<PlaceInRange> worst = worst_in_ranges(design, of, place);
  if (!of.response->over_ranges) return why_undefined_there(design, *of.response);
  if (worst.empty()) return {};
  const MechanismResponse& own = *of.response->over_ranges->of;
  if (find_response(*design.mechanism, own.name).response == nullptr) return {};
  ProblemStatement there = design;
  for (const PlaceInRange& p : worst) {
    there.constants[design.mechanism->parameter(p.parameter)] = p.value;
  }
  const EvaluatedResponse value = evaluate_response(there, own);
  if (std::isfinite(value.is_curve ? value.highest : value.value))
    return fmt::format("it grows without bound about {}", words_of(worst));
  const std::string why = why_undefined_there(there, own);
  return fmt::format("it does not exist at {}{}{}", words_of(worst), why.empty() ? "" : ": ", why);
}

std::string words_of(const std::vector<PlaceInRange>& places) {
  std::vector<std::string> parts;
  for (const PlaceInRange& place : places) {
    parts.push_back(fmt::format("{} = {}", place.parameter, with_unit(place.value, place.unit)));
  }
  return listed(parts);
}

std::vector<std::string> ranges_that_may_decide(const ProblemStatement& design,
                                                const ResponseName& of) {
  if (of.response == nullptr || !of.response->over_ranges || design.laws.empty()) return {};
  const OverRanges& over = *of.response->over_ranges;
  if (over.all_possible(whole_binding(design), {})) return {};
  std::vector<std::string> names;
  for (const TakenRange& range : over.ranges) {
    if (!of.response->possible_by.holds(range.parameter)) continue;
    names.push_back(design.mechanism->parameters[range.parameter].name);
  }
  return names;
}

std::vector<PartOfRange> left_in_ranges(const ProblemStatement& design, const ResponseName& of,
                                        const std::optional<optim::Bounds>& stretch) {
  if (of.response == nullptr || design.laws.empty()) return {};
  if (!of.response->over_cases.empty()) {
    const auto from = stretch ? place_in_case(of, stretch->lower) : std::nullopt;
    const auto to = stretch ? place_in_case(of, stretch->upper) : std::nullopt;
    if (!from || !to) return {};
    return left_in_ranges(design, of.response->over_cases.at(from->part),
                          optim::Bounds{from->place, to->place});
  }
  if (!of.response->over_ranges || !of.response->over_ranges->left) return {};
  if (of.response->curve && !stretch) return {};
  const OverRanges& over = *of.response->over_ranges;
  const Box left = over.left(whole_binding(design), {}, stretch ? &*stretch : nullptr);
  std::vector<PartOfRange> parts;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const MechanismParameter& p = design.mechanism->parameters[over.ranges[i].parameter];
    parts.push_back({p.name, p.unit, left[i].lower, left[i].upper});
  }
  return parts;
}

std::string words_of(const std::vector<PartOfRange>& parts) {
  std::vector<std::string> words;
  for (const PartOfRange& part : parts) {
    if (part.lower == part.upper) {
      words.push_back(fmt::format("{} = {}", part.parameter, with_unit(part.lower, part.unit)));
      continue;
    }
    words.push_back(fmt::format("{} from {} to {}", part.parameter,
                                with_unit(part.lower, part.unit),
                                with_unit(part.upper, part.unit)));
  }
  return listed(words);
}

}  // namespace camlaw::problems
