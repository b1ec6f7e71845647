// SPDX-License-Identifier: MIT
#include "problems/statement/ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "machines/model/given_law.h"
#include "machines/model/load_case.h"
#include "machines/model/robust_number.h"
#include "problems/statement/cases.h"
#include "problems/statement/parameters.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// Whether a response is to be taken over the ranges: that of several cases has them in each.
bool matters(const ProblemStatement& problem, const ResponseName& name) {
  return name.response != nullptr && !name.response->over_ranges &&
         name.response->over_cases.empty() && depends_on(*name.response, taken_ranges(problem));
}

/// The problem's ranges alone.
std::vector<TakenRange> stated_ranges(const ProblemStatement& problem) {
  std::vector<TakenRange> ranges;
  for (const ParameterRange& range : problem.ranges) ranges.push_back({range, false});
  return ranges;
}

/// A parameter itself, as a response.
std::shared_ptr<const MechanismResponse> parameter_response(const ProblemStatement& problem,
                                                            const ResponseName& name) {
  const MechanismParameter& p = problem.mechanism->parameters[name.parameter];
  auto result = std::make_shared<MechanismResponse>();
  result->name = p.name;
  result->unit = p.unit;
  result->meaning = p.meaning;
  result->uses = {name.parameter};
  result->number = [mechanism = problem.mechanism, name](const Binding& binding, optim::Shape) {
    return make_response(*mechanism, name, binding).function();
  };
  return result;
}

/// Whether a range gives the problem's laws something, as a speed gives angles to times that stay.
bool moves_law(const ProblemStatement& problem, const std::vector<TakenRange>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const TakenRange& range) {
    return std::any_of(problem.laws.begin(), problem.laws.end(), [&](const Member& law) {
      return given_parameter(*law.family, range.parameter).has_value();
    });
  });
}

/// At each place of the cycle; where the ranges move the law, over the whole of it.
std::shared_ptr<const MechanismResponse> spread(const ProblemStatement& problem,
                                                const ResponseName& name, bool highest) {
  std::vector<TakenRange> ranges = taken_ranges(problem);
  if (!moves_law(problem, ranges)) return over_ranges(*name.response, std::move(ranges), highest);
  ResponseName part = name;
  if (name.response->curve) part.part = highest ? Part::Highest : Part::Lowest;
  return peak_over_ranges(problem.mechanism, part, std::move(ranges), highest);
}

/// What manufacture does to parameters that a response depends on.
std::vector<VaryingParameter> varying_of(const ProblemStatement& problem,
                                         const MechanismResponse& response) {
  std::vector<VaryingParameter> varying;
  for (const VariationStatement& v : variations_of(problem)) {
    if (v.parameter.of_law) continue;
    const std::size_t parameter = v.parameter.parameter;
    if (!depends_on(response, {{{parameter, 0, 0}, true}})) continue;
    varying.push_back({parameter, v.at(meant_value(problem, v))});
  }
  return varying;
}

using Held = std::shared_ptr<const MechanismResponse>;

/// A response that refers to others, which live as long as it does.
Held holding(std::vector<Held> all) {
  auto held = std::make_shared<const std::vector<Held>>(std::move(all));
  return {held, held->back().get()};
}

/// What one part must hold of a limit: over the problem's ranges, and in several cases at once.
struct OfPart {
  ResponseName name;
  std::vector<Held> held = {};
};

OfPart of_part(const ProblemStatement& problem, const ConstraintStatement& limit, bool is_upper) {
  OfPart result;
  std::vector<ResponseName> parts;
  const auto add = [&](ResponseName own) {
    if (own.response->curve) own.part = is_upper ? Part::Highest : Part::Lowest;
    if (auto over = of_part_over_ranges(problem, own, is_upper)) {
      own.response = over.get();
      result.held.push_back(std::move(over));
    }
    parts.push_back(std::move(own));
  };
  if (limit.in_cases.empty()) {
    add(limit.response);
    result.name = parts.front();
    return result;
  }
  for (const LoadCase& load : problem.cases) {
    const auto& names = limit.in_cases;
    if (std::find(names.begin(), names.end(), load.name) == names.end()) continue;
    add(in_case(*problem.mechanism, limit.response, load));
  }
  WorstCase worst = worst_case(problem.mechanism, std::move(parts),
                               over_name(OverCases::Worst, limit.response.name), is_upper);
  result.held.push_back(std::move(worst.response));
  result.name = std::move(worst.name);
  return result;
}

/// A limit that need not hold for every part: each of its sides on the quantile of its worst value.
/// `own`: the response, where it is none of the mechanism's.
std::vector<ConstraintStatement> with_reliability(const ProblemStatement& problem,
                                                  const ConstraintStatement& stated,
                                                  const ConstraintStatement& limit,
                                                  const std::vector<VaryingParameter>& varying,
                                                  const Held& own) {
  std::vector<ConstraintStatement> sides;
  const bool is_curve = static_cast<bool>(limit.response.response->curve);
  const auto add = [&](bool is_upper, double bound) {
    ConstraintStatement side = limit;
    side.lower.reset();
    side.upper.reset();
    (is_upper ? side.upper : side.lower) = bound;
    side.is_size = limit.is_size || limit.response.part == Part::Magnitude;
    side.one_value = stated.response;
    if (is_curve) side.one_value.part = Part::Value;
    const double wanted = limit.searched_share.value_or(*limit.reliability);
    Robust robust{true, 0, is_upper ? wanted : 1 - wanted, *limit.reliability};
    // Where these parts promise too much, more of them are asked.
    constexpr double kFewer = 0.8;
    const double promised = 1 - *limit.reliability;
    if (1 - wanted < kFewer * promised) robust.parts_for = 1 - promised / 4;
    OfPart part = of_part(problem, limit, is_upper);
    std::vector<Held> held = std::move(part.held);
    if (own) held.push_back(own);
    held.push_back(robust_number(problem.mechanism, part.name, varying, robust));
    side.of_range = holding(std::move(held));
    side.response = part.name;
    side.response.response = side.of_range.get();
    side.response.part = Part::Value;
    sides.push_back(std::move(side));
  };
  if (limit.upper) add(true, *limit.upper);
  if (limit.lower) add(false, *limit.lower);
  if (limit.response.part == Part::Magnitude && limit.upper) add(false, -*limit.upper);
  return sides;
}

/// The largest size of a curve over the ranges: that of the highest values and the lowest ones, one
/// behind the other.
ObjectiveStatement size_over_ranges(const ProblemStatement& problem, ObjectiveStatement objective) {
  struct Owned {
    std::shared_ptr<const MechanismResponse> highest, lowest, both;
  };
  auto owned = std::make_shared<Owned>();
  owned->highest = spread(problem, objective.response, true);
  owned->lowest = spread(problem, objective.response, false);
  std::vector<ResponseName> parts(2, objective.response);
  parts[0].response = owned->highest.get();
  parts[1].response = owned->lowest.get();
  WorstCase wanted = worst_case(problem.mechanism, std::move(parts), objective.response.name, true);
  owned->both = std::move(wanted.response);
  objective.of_ranges = std::shared_ptr<const MechanismResponse>(owned, owned->both.get());
  objective.response = std::move(wanted.name);
  return objective;
}

}  // namespace

std::vector<TakenRange> taken_ranges(const ProblemStatement& problem) {
  std::vector<TakenRange> taken = stated_ranges(problem);
  for (const VariationStatement& v : variations_of(problem)) {
    if (v.parameter.of_law) continue;
    const optim::Variation off = v.at(meant_value(problem, v));
    taken.push_back({{v.parameter.parameter, off.lower, off.upper}, true});
  }
  return taken;
}

bool changes_over_ranges(const ProblemStatement& problem, const ResponseName& name) {
  const std::vector<TakenRange> taken = taken_ranges(problem);
  if (name.response != nullptr) return depends_on(*name.response, taken);
  return std::any_of(taken.begin(), taken.end(),
                     [&](const TakenRange& range) { return range.parameter == name.parameter; });
}

bool changes_by_manufacture(const ProblemStatement& problem, const ResponseName& name) {
  if (name.response != nullptr) return !varying_of(problem, *name.response).empty();
  return !varying_of(problem, *parameter_response(problem, name)).empty();
}

std::shared_ptr<const MechanismResponse> highest_over_ranges(const ProblemStatement& problem,
                                                             const ResponseName& name,
                                                             bool highest) {
  return matters(problem, name) ? spread(problem, name, highest) : nullptr;
}

std::vector<ConstraintStatement> over_ranges(const ProblemStatement& problem,
                                             const ConstraintStatement& stated) {
  ConstraintStatement limit = stated;
  std::shared_ptr<const MechanismResponse> own;
  if (limit.response.response == nullptr) {
    own = parameter_response(problem, limit.response);
    limit.response.response = own.get();
  }
  if (!matters(problem, limit.response)) return {stated};
  if (limit.reliability) {
    const auto varying = varying_of(problem, *limit.response.response);
    if (!varying.empty()) return with_reliability(problem, stated, limit, varying, own);
  }
  std::vector<ConstraintStatement> sides;
  const auto add = [&](bool is_upper, double bound) {
    ConstraintStatement side = limit;
    side.lower.reset();
    side.upper.reset();
    (is_upper ? side.upper : side.lower) = bound;
    side.of_range = spread(problem, limit.response, is_upper);
    side.response.response = side.of_range.get();
    const bool is_curve = static_cast<bool>(limit.response.response->curve);
    side.is_size = limit.is_size || limit.response.part == Part::Magnitude;
    if (is_curve) side.response.part = Part::Value;
    sides.push_back(std::move(side));
  };
  if (limit.upper) add(true, *limit.upper);
  if (limit.lower) add(false, *limit.lower);
  if (limit.response.part == Part::Magnitude && limit.upper) add(false, -*limit.upper);
  return sides;
}

std::shared_ptr<const MechanismResponse> of_part_over_ranges(const ProblemStatement& problem,
                                                             const ResponseName& name,
                                                             bool highest) {
  std::vector<TakenRange> ranges = stated_ranges(problem);
  std::erase_if(ranges, [&](const auto& range) { return !depends_on(*name.response, {range}); });
  if (ranges.empty()) return nullptr;
  return number_over_ranges(problem.mechanism, name, std::move(ranges),
                            highest || name.part == Part::Magnitude);
}

bool is_quantile(const ConstraintStatement& limit) {
  return limit.reliability && limit.of_range && !limit.of_range->over_ranges;
}

void refuse_reliabilities(const ProblemStatement& problem, const std::string& what) {
  const auto found =
      std::find_if(problem.constraints.begin(), problem.constraints.end(), is_quantile);
  if (found == problem.constraints.end()) return;
  throw std::invalid_argument(
      fmt::format("{}: the limit on {} has a reliability, which camlaw optimize checks with parts "
                  "that its search did not see, but {} does not; drop reliability, and use camlaw "
                  "tolerance to find what share of the parts meets the limits",
                  problem.source, found->response.name, what));
}

ConstraintStatement as_stated(const ProblemStatement& problem, ConstraintStatement limit) {
  if (!is_quantile(limit)) return limit;
  limit.response = std::exchange(limit.one_value, {});
  if (limit.response.response != nullptr) {
    limit.response.response =
        find_response(*problem.mechanism, limit.response.response->name).response;
  }
  limit.of_range = nullptr;
  return limit;
}

std::vector<ConstraintStatement> of_one_value(const ProblemStatement& problem,
                                              const ConstraintStatement& limit) {
  if (!is_quantile(limit)) return {limit};
  ConstraintStatement stated = as_stated(problem, limit);
  stated.reliability.reset();
  if (stated.in_cases.empty()) return {stated};
  const std::vector<std::string> cases = std::exchange(stated.in_cases, {});
  return in_cases(problem, stated, cases);
}

ConstraintStatement searched_at(const ProblemStatement& problem, const ConstraintStatement& limit,
                                double share) {
  ConstraintStatement again = as_stated(problem, limit);
  again.searched_share = share;
  return over_ranges(problem, again).front();  // it has one side
}

std::vector<ConstraintStatement> of_each_part(const ProblemStatement& problem,
                                              const ConstraintStatement& limit) {
  std::vector<ConstraintStatement> all = of_one_value(problem, limit);
  for (ConstraintStatement& own : all) {
    if (own.response.response == nullptr) continue;
    ResponseName name = own.response;
    if (name.response->curve) name.part = own.upper ? Part::Highest : Part::Lowest;
    own.of_range = of_part_over_ranges(problem, name, own.upper.has_value());
    if (own.of_range) own.response.response = own.of_range.get();
  }
  return all;
}

ObjectiveStatement over_parts(const ProblemStatement& problem, ObjectiveStatement objective) {
  objective.of_ranges = nullptr;
  const auto varying = varying_of(problem, *objective.response.response);
  if (varying.empty()) return objective;
  objective.one_value = objective.response;
  ResponseName of = objective.response;
  Held over;
  if (!objective.over) {  // whose parts are over ranges already
    over = of_part_over_ranges(problem, of, objective.sense == optim::Sense::Minimize);
  }
  if (over) of.response = over.get();
  objective.of_ranges =
      holding({std::move(over), robust_number(problem.mechanism, of, varying, *objective.robust)});
  objective.response.response = objective.of_ranges.get();
  objective.response.part = Part::Value;
  objective.response.window.reset();
  objective.response.name += fmt::format(" ({})", objective.robust->text());
  return objective;
}

ObjectiveStatement over_ranges(const ProblemStatement& problem, ObjectiveStatement objective) {
  if (objective.over || !matters(problem, objective.response)) return objective;
  if (objective.robust && changes_by_manufacture(problem, objective.response)) {
    return over_parts(problem, std::move(objective));
  }
  const bool highest = objective.sense == optim::Sense::Minimize;
  objective.one_value = objective.response;
  const bool is_size = objective.response.part == Part::Magnitude;
  if (is_size && !moves_law(problem, taken_ranges(problem))) {
    return size_over_ranges(problem, std::move(objective));
  }
  objective.of_ranges =
      is_size ? peak_over_ranges(problem.mechanism, objective.response, taken_ranges(problem), true)
              : spread(problem, objective.response, highest);
  objective.response.response = objective.of_ranges.get();
  if (!objective.of_ranges->curve) {
    objective.response.part = Part::Value;
    objective.response.window.reset();
  }
  return objective;
}

}  // namespace camlaw::problems
