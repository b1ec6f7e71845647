// SPDX-License-Identifier: MIT
#include "problems/tolerance/worst_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "machines/model/fixed_binding.h"
#include "machines/model/over_ranges.h"
#include "optim/cycle/extremes.h"
#include "optim/cycle/scales.h"
#include "optim/search/interruptible.h"
#include "optim/verdict/design_point.h"
#include "optim/verdict/limits.h"
#include "problems/statement/bind.h"
#include "problems/statement/ranges.h"

namespace camlaw::problems {
namespace {

using optim::kInfinity, optim::Part;

/// One side of a limit of the design.
struct LimitSide {
  std::size_t limit;
  bool is_upper;
  double bound, tolerance;
  double sign() const { return is_upper ? 1 : -1; }
};

std::vector<LimitSide> sides_of(const VariedDesign& varied) {
  const optim::Scales scales = [&] {
    optim::Problem problem = varied.problem;
    problem.objectives = {optim::no_objective()};
    return optim::scales(problem, varied.meant);
  }();
  std::vector<LimitSide> result;
  for (std::size_t i = 0; i < varied.design.constraints.size(); ++i) {
    const ConstraintStatement& c = varied.design.constraints[i];
    const double tolerance = scales.constraints[i].tolerance;
    if (c.upper) result.push_back({i, true, *c.upper, tolerance});
    if (c.lower) result.push_back({i, false, *c.lower, tolerance});
    const bool is_size = c.response.part == Part::Magnitude && c.upper;
    if (is_size) result.push_back({i, false, -*c.upper, tolerance});
  }
  return result;
}

Binding fixed(const ProblemStatement& design) {
  return fixed_binding(design.constants, design.laws.front());
}

/// The variations as ranges, so large a share of them; those of the machine's own parameters.
std::vector<ParameterRange> ranges_of(const VariedDesign& varied, double share) {
  std::vector<ParameterRange> result = varied.design.ranges;
  for (std::size_t i = 0; i < varied.statements.size(); ++i) {
    const NamedParameter& p = varied.statements[i].parameter;
    const optim::Variation& v = varied.variations[i];
    if (p.of_law || (v.lower == 0 && v.upper == 0)) continue;
    result.push_back(
        {p.parameter, varied.meant[i] + share * v.lower, varied.meant[i] + share * v.upper});
  }
  return result;
}

/// A side of a limit over all parts, as a curve or a number of nothing.
struct OverParts {
  ConstraintStatement side;
  optim::Response response;
};

OverParts over_parts(const VariedDesign& varied, const LimitSide& side, double share) {
  ProblemStatement asked = varied.design;
  asked.ranges = ranges_of(varied, share);
  ConstraintStatement limit = varied.design.constraints[side.limit];
  if (limit.response.response != nullptr && limit.response.response->over_ranges) {
    limit.of_range = limit.response.response->over_ranges->of;  // over these ranges too
    limit.response.response = limit.of_range.get();
  }
  if (limit.response.part == Part::Magnitude) limit.response.part = Part::Value;
  limit.lower.reset();
  limit.upper.reset();
  (side.is_upper ? limit.upper : limit.lower) = side.bound;
  OverParts result{over_ranges(asked, limit).front(), {}};
  asked.constraints = {result.side};
  result.response =
      optim::interruptible(constraints_of(asked, fixed(asked)).front().response, varied.deadline);
  return result;
}

bool sees_varied_law(const VariedDesign& varied, const LimitSide& side) {
  const ConstraintStatement& c = varied.design.constraints[side.limit];
  if (!varied.varies_law()) return false;
  return c.response.response == nullptr || c.of_law || c.response.response->sees_law ||
         !c.response.response->inner.empty();
}

WorstPart part_of(const VariedDesign& varied, const LimitSide& side) {
  const optim::Response& response = varied.problem.constraints[side.limit].response;
  WorstPart result;
  result.limit = side.limit;
  result.name = response.name;
  result.unit = response.unit;
  result.is_upper = side.is_upper;
  result.bound = side.bound;
  result.tolerance = side.tolerance;
  result.slack = kInfinity;
  result.part.assign(varied.meant.size(), std::numeric_limits<double>::quiet_NaN());
  return result;
}

void take(WorstPart& result, double value, std::optional<double> angle, double sign) {
  result.value = value;
  result.margin = sign * (result.bound - value);
  result.angle = angle;
}

/// The values of the parameters at the worst place, in the order of the variations.
void name_part(const VariedDesign& varied, const OverParts& over, const optim::Place* place,
               WorstPart& result) {
  const MechanismResponse* response = over.side.response.response;
  if (response == nullptr || !response->over_ranges) return;
  const OverRanges& ranges = *response->over_ranges;
  const std::vector<double> worst = ranges.worst(fixed(varied.design), {}, place);
  for (std::size_t k = 0; k < worst.size(); ++k) {
    for (std::size_t i = 0; i < varied.statements.size(); ++i) {
      const NamedParameter& p = varied.statements[i].parameter;
      if (!p.of_law && p.parameter == ranges.ranges[k].parameter) result.part[i] = worst[k];
    }
  }
}

/// By intervals over angle and parts together.
WorstPart proved_part(const VariedDesign& varied, const LimitSide& side, double share) {
  WorstPart result = part_of(varied, side);
  const OverParts over = over_parts(varied, side, share);
  const double sign = side.sign(), bound = sign * side.bound + side.tolerance;
  optim::Place place;
  if (over.response.is_curve()) {
    const auto trace = over.response.curve().trace({});
    const optim::CycleProof held = optim::prove_below(*trace, sign, bound);
    const double size = std::abs(held.worst.value);
    const optim::ProvedExtreme peak = optim::proved_highest(*trace, sign, size);
    place = peak.peak.place;
    take(result, peak.peak.value, place.angle, sign);
    if (peak.proved) result.slack = peak.slack;
    result.holds = held.proved ? Holds::Proved : Holds::NotProved;
    name_part(varied, over, &place, result);
  } else {
    const optim::Function f = over.response.function();
    take(result, f.proved().value({}), {}, sign);
    const optim::Bounds exact = f.enclose({});
    const double slack = sign > 0 ? exact.upper - result.value : result.value - exact.lower;
    if (std::isfinite(slack)) result.slack = std::max(slack, 0.0);
    name_part(varied, over, nullptr, result);
  }
  const double left = result.margin + side.tolerance;
  // That the limit holds bounds the worst part too.
  if (result.holds == Holds::Proved) result.slack = std::min(result.slack, std::max(left, 0.0));
  if (left >= result.slack) result.holds = Holds::Proved;
  if (!(left >= 0)) result.holds = Holds::Broken;
  if (result.holds == Holds::NotProved) {
    result.why_not = std::isfinite(result.slack) ? "the bounds do not close on the limit"
                                                 : "intervals do not bound it over the variations";
  }
  return result;
}

/// A limit's report at one part.
class OnePart {
 public:
  OnePart(const VariedDesign& varied, const LimitSide& side) {
    problem_.variables = varied.problem.variables;
    problem_.objectives = {optim::no_objective()};
    optim::Constraint limit = varied.problem.constraints[side.limit];
    limit.lower.reset();
    limit.upper.reset();
    (side.is_upper ? limit.upper : limit.lower) = side.bound;
    limit.tolerance = side.tolerance;
    problem_.constraints = {limit};
    slopes_ = optim::room_slopes(problem_, 0, varied.meant);
    scales_ = optim::scales(problem_, varied.meant);
  }

  optim::LimitReport report(const std::vector<double>& part) const {
    return optim::limit_reports(problem_, scales_, part, false).front();
  }
  /// What is not a number is worst of all.
  double room(const std::vector<double>& part, std::vector<double>& slopes) const {
    slopes.assign(part.size(), 0.0);
    const double room = slopes_(part, slopes);
    return std::isnan(room) ? -kInfinity : room;
  }

 private:
  optim::Problem problem_;
  optim::RoomSlopes slopes_;
  optim::Scales scales_;
};

/// All corners, and from the worst of them downhill: no proof.
WorstPart searched_part(const VariedDesign& varied, const LimitSide& side, double share) {
  constexpr int kSteps = 40;  // a step that gains nothing is quartered: ten of these end at 1e-6
  const OnePart one(varied, side);
  const std::size_t n = varied.meant.size();
  const auto end = [&](std::size_t i, bool upper) {
    const optim::Variation& v = varied.variations[i];
    return varied.meant[i] + share * (upper ? v.upper : v.lower);
  };
  std::vector<double> worst = varied.meant, slopes;
  double least = one.room(worst, slopes);
  for (std::size_t bits = 0; bits < (std::size_t{1} << n); ++bits) {
    std::vector<double> corner(n);
    for (std::size_t i = 0; i < n; ++i) corner[i] = end(i, ((bits >> i) & 1U) != 0);
    const double room = one.room(corner, slopes);
    if (room < least) least = room, worst = corner;
  }
  double step = 1;
  for (int k = 0; k < kSteps && std::isfinite(least) && step > 1e-6; ++k) {
    one.room(worst, slopes);
    std::vector<double> next = worst;
    double steepest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      steepest = std::max(steepest, std::abs(slopes[i]) * (end(i, true) - end(i, false)));
    }
    if (steepest == 0) break;
    for (std::size_t i = 0; i < n; ++i) {
      const double width = end(i, true) - end(i, false);
      next[i] = std::clamp(worst[i] - step * width * width * slopes[i] / steepest, end(i, false),
                           end(i, true));
    }
    std::vector<double> ignored;
    const double room = one.room(next, ignored);
    if (room < least) {
      least = room;
      worst = std::move(next);
    } else {
      step /= 4;
    }
  }
  WorstPart result = part_of(varied, side);
  const optim::LimitReport report = one.report(worst);
  take(result, report.value, report.worst_angle, side.sign());
  result.part = worst;
  result.holds = result.margin + side.tolerance >= 0 ? Holds::NotProved : Holds::Broken;
  if (result.holds == Holds::NotProved) {
    result.why_not = "the law itself varies: every corner was looked at, which is not a proof";
  }
  return result;
}

WorstPart worst_part(const VariedDesign& varied, const LimitSide& side, double share) {
  return sees_varied_law(varied, side) ? searched_part(varied, side, share)
                                       : proved_part(varied, side, share);
}

/// The room of the worst part that a search finds.
double searched_room(const VariedDesign& varied, const LimitSide& side, double share) {
  if (sees_varied_law(varied, side)) {
    const WorstPart found = searched_part(varied, side, share);
    return found.margin + side.tolerance;
  }
  const OverParts over = over_parts(varied, side, share);
  const double value = over.response.is_curve()
                           ? optim::highest(*over.response.curve().trace({}), side.sign()).value
                           : over.response.function().value({});
  return side.sign() * (side.bound - value) + side.tolerance;
}

/// For every part up to that share: the box holds the nominal part, and with it all that are
/// smaller.
bool is_proved_up_to(const VariedDesign& varied, const LimitSide& side, double share) {
  if (sees_varied_law(varied, side)) return false;
  VariedDesign whole = varied;
  for (optim::Variation& v : whole.variations) {
    v.lower = std::min(v.lower, 0.0);
    v.upper = std::max(v.upper, 0.0);
  }
  const OverParts over = over_parts(whole, side, share);
  const double sign = side.sign(), bound = sign * side.bound + side.tolerance;
  if (over.response.is_curve()) {
    return optim::prove_below(*over.response.curve().trace({}), sign, bound).proved;
  }
  const optim::Bounds exact = over.response.function().enclose({});
  return sign > 0 ? exact.upper <= bound : -exact.lower <= bound;
}

/// Up to which factor every value is one that its parameter accepts.
double accepted_factor(const VariedDesign& varied) {
  double factor = kLargestFactor;
  for (std::size_t i = 0; i < varied.statements.size(); ++i) {
    const NamedParameter& p = varied.statements[i].parameter;
    const optim::Variation& v = varied.variations[i];
    const double meant = varied.meant[i];
    if (v.upper > 0) factor = std::min(factor, (p.high - meant) / v.upper);
    if (v.lower < 0) factor = std::min(factor, (p.low - meant) / v.lower);
  }
  return factor;
}

}  // namespace

std::string_view to_string(Holds holds) {
  switch (holds) {
    case Holds::Proved:
      return "holds, proved";
    case Holds::Broken:
      return "breaks";
    case Holds::NotProved:
      break;
  }
  return "not proved";
}

std::vector<WorstPart> worst_parts(const VariedDesign& varied, double share) {
  std::vector<WorstPart> result;
  for (const LimitSide& side : sides_of(varied)) result.push_back(worst_part(varied, side, share));
  return result;
}

std::vector<std::vector<std::size_t>> broken_alone(const VariedDesign& varied) {
  std::vector<LimitSide> sides = sides_of(varied);
  std::erase_if(sides, [&, slopes = std::vector<double>()](const LimitSide& side) mutable {
    return !(OnePart(varied, side).room(varied.meant, slopes) >= 0);
  });
  std::vector<std::vector<std::size_t>> result(varied.meant.size());
  for (std::size_t i = 0; i < varied.meant.size(); ++i) {
    VariedDesign only = varied;
    for (std::size_t k = 0; k < only.variations.size(); ++k) {
      if (k != i) only.variations[k].lower = only.variations[k].upper = 0;
    }
    for (const LimitSide& side : sides) {
      const bool is_known = !result[i].empty() && result[i].back() == side.limit;
      if (!is_known && !(searched_room(only, side, 1) >= 0)) result[i].push_back(side.limit);
    }
  }
  return result;
}

BreakFactor break_factor(const VariedDesign& varied, const WorstPart& worst) {
  // Every third step halves, so that ten of them alone reach a thousandth.
  constexpr int kSteps = 30;
  // Four digits of a factor are shown; the proof fails at the factor itself, where the limit has no
  // room.
  constexpr double kExact = 1e-4, kProvedTo = 0.99;
  const LimitSide side{worst.limit, worst.is_upper, worst.bound, worst.tolerance};
  const double most = accepted_factor(varied);
  const auto room = [&](double share) {
    const double left = searched_room(varied, side, share);
    return std::isnan(left) ? -kInfinity : left;
  };
  const OnePart one(varied, side);
  std::vector<double> slopes;
  double low = 0, low_room = one.room(varied.meant, slopes);
  if (!(low_room >= 0)) return {0, true, most};
  double high = 1, high_room = worst.margin + worst.tolerance;
  if (!std::isfinite(high_room)) high_room = room(1);
  while (high_room >= 0 && high < most) {
    low = high, low_room = high_room;
    // A little further than a straight line says, and at most four times as far.
    const double slope = (one.room(varied.meant, slopes) - high_room) / high;
    const double reach = slope > 0 ? high + 1.1 * high_room / slope : 4 * high;
    high = std::min({std::max(reach, 1.05 * high), 4 * high, most});
    high_room = room(high);
  }
  if (high_room >= 0) return {kInfinity, is_proved_up_to(varied, side, high), most};
  for (int k = 0; k < kSteps && high - low > kExact * high; ++k) {
    const bool is_finite = std::isfinite(high_room) && k % 3 != 2;
    const double share = is_finite ? low_room / (low_room - high_room) : 0.5;
    const double middle = low + std::clamp(share, 0.02, 0.98) * (high - low);
    const double left = room(middle);
    (left >= 0 ? low : high) = middle;
    (left >= 0 ? low_room : high_room) = left;
  }
  return {low, is_proved_up_to(varied, side, kProvedTo * low), most};
}

}  // namespace camlaw::problems
