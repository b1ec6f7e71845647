// SPDX-License-Identifier: MIT
#include "optim/search/working_set.h"

#include <algorithm>
#include <cmath>

#include "optim/search/exchange.h"
#include "optim/search/plan.h"

namespace camlaw::optim {
namespace {

/// What a curve is at a place of a design, and how far apart a row's value is that says something
/// else: beside a place where the curve jumps, as friction does where a motion begins, a row of
/// that place may not see the peak.
struct SeenAt {
  Design x;
  double value, apart;
};

/// Whether a place is in the set but for rounding: asking again would not move the solver.
bool is_known(const CurveSide& side, Place place, const std::vector<double>& breaks,
              const SeenAt& seen) {
  const double near = 1e-10 * (breaks.back() - breaks.front());
  const auto says_so = [&](const HeldPlace& held) {
    return std::abs(held.function.value(seen.x) - seen.value) <= seen.apart;
  };
  return std::any_of(side.places.begin(), side.places.end(), [&](const HeldPlace& held) {
    const Place& other = held.place;
    if (other.from_left != place.from_left || other.joint != place.joint) return false;
    if (place.joint >= 0 || other.angle == place.angle) return true;
    return std::abs(other.angle - place.angle) <= near && says_so(held);
  });
}

/// Of each stretch. Few stretches get more places each: the first program should already be
/// bounded.
int steps_at_first(std::size_t breaks) {
  constexpr std::size_t kFewStretches = 16;
  return breaks <= kFewStretches ? 8 : 1;
}

/// Whether rows of a curve can be told to say the same.
bool tells(const Curve& curve) { return curve.shape() == Shape::Linear && !curve.breaks_move(); }

/// Where one row would hold a peak as the two rows nearest to it do together.
struct Balance {
  double before, after;  ///< the two
  double angle;
};

/// None where no two rows hold the peak.
std::optional<Balance> balance(const CurveSide& side, Place peak) {
  constexpr double kIdle = 1e-9;  // an interior-point method leaves some multiplier to all rows
  const HeldPlace *before = nullptr, *after = nullptr;
  for (const HeldPlace& held : side.places) {
    if (!(std::abs(held.multiplier) > kIdle)) continue;
    const double angle = held.place.angle;
    if (angle < peak.angle && (before == nullptr || angle > before->place.angle)) before = &held;
    if (angle >= peak.angle && (after == nullptr || angle < after->place.angle)) after = &held;
  }
  if (before == nullptr || after == nullptr) return {};
  const double from = before->place.angle, to = after->place.angle;
  const double share =
      std::abs(after->multiplier) / (std::abs(before->multiplier) + std::abs(after->multiplier));
  return Balance{from, to, from + share * (to - from)};
}

/// The places that are to hold a peak: that of balance, or where this is known closely two beside
/// it, which hold the slope as well. Between these the curve rises by no more than `least`.
std::vector<double> holders(const Balance& at, const Trace& trace, double least) {
  // (XM6) misses the peak by the square of the distance: nearer, two rows enclose it.
  constexpr double kClose = 100;
  const double half = std::sqrt(2 * least / std::abs(trace.at({at.angle})[2]));
  const double nearest = std::min(at.angle - at.before, at.after - at.angle);
  if (!(nearest < kClose * half)) return {at.angle};
  std::vector<double> angles;
  if (at.angle - half > at.before) angles.push_back(at.angle - half);
  if (at.angle + half < at.after) angles.push_back(at.angle + half);
  return angles;
}

}  // namespace

std::size_t places_at_first(std::size_t breaks) {
  return (breaks - 1) * static_cast<std::size_t>(steps_at_first(breaks) + 1);
}

WorkingSet::WorkingSet(const Problem& problem, const Scales& scales, Aim aim)
    : problem_(problem),
      scales_(scales),
      aim_(aim),
      auxiliary_(aim == Aim::LeastViolation || problem.objective().response.is_curve()) {
  const Objective& objective = problem.objective();
  if (aim == Aim::Optimum && objective.response.is_curve()) {
    const auto add = [&](double sign) {
      sides_.push_back({&objective.response,
                        sign,
                        0,
                        true,
                        scales.objective,
                        scales.objective_tolerance,
                        {},
                        {},
                        {}});
    };
    if (objective.part != Part::Lowest) add(1);
    if (objective.part != Part::Highest) add(-1);
  }
  std::map<std::pair<const Curve*, bool>, std::size_t> known;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    if (!c.response.is_curve()) continue;
    const ConstraintScale& own = scales.constraints[i];
    const auto add = [&](double sign, double bound) {
      add_side({&c.response, sign, bound, false, own.scale, own.tolerance, i, {}, {}}, known);
    };
    if (c.upper) add(1, *c.upper);
    if (c.lower) add(-1, *c.lower);
  }
}

/// Of limits on one side of one curve the tightest holds the others too.
void WorkingSet::add_side(CurveSide side,
                          std::map<std::pair<const Curve*, bool>, std::size_t>& known) {
  const auto holds = [](const CurveSide& one, const CurveSide& other) {
    return one.sign * one.bound <= other.sign * other.bound && one.size <= other.size &&
           one.tolerance <= other.tolerance;
  };
  const auto key = std::pair(&side.response->curve(), side.sign > 0);
  const auto [at, fresh] = known.emplace(key, sides_.size());
  if (fresh) {
    sides_.push_back(std::move(side));
    return;
  }
  CurveSide& tightest = sides_[at->second];
  if (holds(tightest, side)) return;
  if (holds(side, tightest)) {
    tightest = std::move(side);
  } else {
    sides_.push_back(std::move(side));
  }
}

/// Only of limits, and only where they are not eased: then they do not vanish.
RestWeights WorkingSet::weights_of(const CurveSide& side, Design x) const {
  if (side.of_peak || is_eased(side.constraint)) return {};
  return RestWeights(side.response->curve(), side.bound, x);
}

void WorkingSet::begin_at(Design x) {
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    const auto same = [&](const CurveSide& other) {
      return other.response == sides_[s].response && other.constraint == sides_[s].constraint &&
             other.sign * other.bound == sides_[s].sign * sides_[s].bound;
    };
    const auto first = std::find_if(sides_.begin(), sides_.end(), same);
    sides_[s].group = static_cast<std::size_t>(first - sides_.begin());
  }
  std::map<std::size_t, LinearRows> rows;
  for (CurveSide& side : sides_) begin_side(side, x, rows);
}

void WorkingSet::begin_side(CurveSide& side, Design x, std::map<std::size_t, LinearRows>& rows) {
  constexpr double kRounding = 1e-9;  // of slopes
  const Curve& curve = side.response->curve();
  const RestWeights weights = weights_of(side, x);
  std::size_t number = 0;
  for (const Rest& rest : weights.rests()) {
    const double size = typical_change(rest.leading, x, scales_.variables);
    if (size > 0 && std::isfinite(size))
      rests_.push_back({rest.leading, side.sign, size, *side.constraint, number});
    ++number;
  }
  const auto is_moved = [&](const Function& function, double weight) {
    if (side.of_peak || is_eased(side.constraint)) return true;
    const double slope = typical_change(function, x, scales_.variables);
    return !vanishes(slope / (side.size * weight));
  };
  const bool tells_rows = tells(curve);
  LinearRows& known = rows.try_emplace(side.group, x, kRounding).first->second;
  const auto trace = curve.trace(x);
  const std::vector<double> breaks = trace->breaks();
  const int steps = steps_at_first(breaks.size());
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (int i = 0; i <= steps; ++i) {
      const Place place = curve.tied(even_place(breaks[k], breaks[k + 1], steps, i), x);
      if (weights.is_rest(place)) continue;
      HeldPlace held{place, weights.at(place), curve.at(place)};
      if (!is_moved(held.function, held.weight)) continue;
      if (tells_rows && !known.add(held.function, side.sign, kRounding * side.size)) continue;
      side.places.push_back(std::move(held));
    }
  }
  if (aim_ == Aim::Optimum && is_linear(problem_) && is_large(problem_))
    hold_start_peaks(side, *trace, x, known);
}

void WorkingSet::hold_start_peaks(CurveSide& side, const Trace& trace, Design x,
                                  LinearRows& known) {
  constexpr double kRoom = 1e-2, kBeside = 1e-6;  // of the limit
  constexpr double kRounding = 1e-9;              // of slopes
  if (!tells(side.response->curve())) return;
  const double limit = limit_of(side, side.of_peak ? auxiliary_start(x) : 0);
  const std::vector<double> breaks = trace.breaks();
  const Curve& curve = side.response->curve();
  const RestWeights weights = weights_of(side, x);
  const auto hold = [&](double angle) {
    const Place place = curve.tied({angle}, x);
    HeldPlace held{place, weights.at(place), curve.at(place)};
    if (weights.is_rest(place) || !known.add(held.function, side.sign, kRounding * side.size))
      return;
    side.places.push_back(std::move(held));
  };
  for (const Extreme& peak : local_maxima(trace, side.sign)) {
    const double angle = peak.place.angle;
    const auto after = std::upper_bound(breaks.begin(), breaks.end(), angle);
    const bool is_inside = after != breaks.begin() && after != breaks.end() && *(after - 1) < angle;
    if (!is_inside || limit - side.sign * peak.value > kRoom * std::abs(limit)) continue;
    hold(angle);
    // Between these a curve of this bend rises by no more than that share.
    const double half = std::sqrt(2 * kBeside * std::abs(limit / trace.at(peak.place)[2]));
    if (angle - half > *(after - 1)) hold(angle - half);
    if (angle + half < *after) hold(angle + half);
  }
}

bool WorkingSet::is_eased(std::optional<std::size_t> constraint) const {
  return aim_ == Aim::LeastViolation &&
         !(constraint && problem_.constraints[*constraint].is_strict);
}

/// What sign * curve of a side is held below.
double WorkingSet::limit_of(const CurveSide& side, double auxiliary) const {
  const double slack = is_eased(side.constraint) ? side.size * auxiliary : 0;
  if (!side.of_peak) return side.sign * side.bound + slack;
  // A minimised peak is bounded from above by the auxiliary, a maximised lowest value from below,
  // a magnitude from both sides.
  const bool both = problem_.objective().part == Part::Magnitude;
  return (both ? auxiliary : side.sign * auxiliary) + slack;
}

void WorkingSet::take_multipliers(std::span<const double> rows) {
  std::size_t next = row_groups().front();
  for (CurveSide& side : sides_) {
    for (HeldPlace& held : side.places) held.multiplier = rows.empty() ? 0 : rows[next++];
  }
}

std::size_t WorkingSet::add_violated(Design x, double auxiliary, double share) {
  std::size_t added = 0;
  std::map<std::size_t, LinearRows> rows;
  for (CurveSide& side : sides_) {
    added += add_violated_places(side, x, limit_of(side, auxiliary), share * side.tolerance, rows);
  }
  return added;
}

/// Adds the peaks of one side that are above `limit` by more than `least`.
std::size_t WorkingSet::add_violated_places(CurveSide& side, Design x, double limit, double least,
                                            std::map<std::size_t, LinearRows>& rows) {
  // Rows say the same if their slopes differ by less than a millionth of the steepest and their
  // values by less than a thousandth of the excess.
  constexpr double kAlike = 1e-6, kEqual = 1e-3;
  const Curve& curve = side.response->curve();
  const auto trace = curve.trace(x);
  const std::vector<double> breaks = trace->breaks();
  const RestWeights weights = weights_of(side, x);
  LinearRows& fresh = rows.try_emplace(side.group, x, kAlike).first->second;
  const bool tells_rows = tells(curve);
  const std::size_t before = side.places.size();
  const auto add = [&](Place where, double above) {
    const Place place = curve.tied(where, x);
    const SeenAt seen{x, trace->at(place)[0], 0.5 * above};
    if (weights.is_rest(place) || is_known(side, place, breaks, seen)) return false;
    HeldPlace held{place, weights.at(place), curve.at(place)};
    if (tells_rows && !fresh.add(held.function, side.sign, kEqual * above)) return false;
    side.places.push_back(std::move(held));
    return true;
  };
  for (const Extreme& peak : local_maxima(*trace, side.sign)) {
    const double above = side.sign * peak.value - limit;
    if (!(above > least) || !add(peak.place, above)) continue;
    const auto at = balance(side, peak.place);
    if (!at) continue;
    for (const double angle : holders(*at, *trace, least)) add({angle}, above);
  }
  return side.places.size() - before;
}

Row WorkingSet::number_row(std::size_t constraint) const {
  const Constraint& c = problem_.constraints[constraint];
  return {.function = c.response.function(),
          .lower = c.lower.value_or(-kInfinity),
          .upper = c.upper.value_or(kInfinity),
          .size = scales_.constraints[constraint].scale,
          .constraint = constraint};
}

void WorkingSet::add_rows(std::vector<Row>& rows) const {
  const std::size_t auxiliary = problem_.variables.size();
  for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
    const Constraint& c = problem_.constraints[i];
    if (c.response.is_curve()) continue;
    const Row row = number_row(i);
    if (!is_eased(i)) {
      rows.push_back(row);
      continue;
    }
    // Either side may be passed by the same share of the size.
    const auto add = [&](double sign) {
      rows.push_back(row);
      (sign > 0 ? rows.back().lower : rows.back().upper) = -sign * kInfinity;
      rows.back().auxiliary = {{auxiliary, -sign * row.size}};
    };
    if (c.upper) add(1);
    if (c.lower) add(-1);
  }
  for (const RestRow& rest : rests_) {
    rows.push_back({.function = rest.leading,
                    .lower = rest.sign > 0 ? -kInfinity : 0,
                    .upper = rest.sign > 0 ? 0 : kInfinity,
                    .size = rest.size,
                    .constraint = rest.constraint,
                    .at_rest = true,
                    .rest = rest.number});
  }
  for (const CurveSide& side : sides_) {
    for (const HeldPlace& held : side.places) {
      Row row{.function = held.function,
              .size = side.size * held.weight,
              .constraint = side.constraint,
              .place = held.place};
      const bool magnitude = side.of_peak && problem_.objective().part == Part::Magnitude;
      (side.sign > 0 ? row.upper : row.lower) = side.of_peak ? 0 : side.bound;
      if (side.of_peak) row.auxiliary = {{auxiliary, magnitude && side.sign < 0 ? 1.0 : -1.0}};
      if (is_eased(side.constraint)) row.auxiliary = {{auxiliary, -side.sign * side.size}};
      rows.push_back(std::move(row));
    }
  }
}

std::vector<std::size_t> WorkingSet::row_groups() const {
  std::size_t numbers = rests_.size();
  for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
    const Constraint& c = problem_.constraints[i];
    if (c.response.is_curve()) continue;
    const bool both = is_eased(i) && c.lower && c.upper;
    numbers += both ? 2 : 1;
  }
  std::vector<std::size_t> groups{numbers};
  for (const CurveSide& side : sides_) groups.push_back(side.places.size());
  return groups;
}

double WorkingSet::auxiliary_start(Design x) const {
  if (aim_ == Aim::Optimum) return objective_value(problem_.objective(), x);
  return std::max(0.0, largest_violation(problem_, scales_, x));
}

Program WorkingSet::program(Design start) const {
  std::vector<ProgramColumn> columns;
  for (std::size_t i = 0; i < problem_.variables.size(); ++i) {
    const Variable& v = problem_.variables[i];
    columns.push_back({v.lower, v.upper, start[i], scales_.variables[i]});
  }
  std::vector<Row> rows;
  add_rows(rows);
  const std::size_t auxiliary = columns.size();
  if (aim_ == Aim::LeastViolation) {
    columns.push_back({0, kInfinity, auxiliary_start(start), 1});
    return Program(std::move(columns), variable_function(auxiliary), 1, 1, std::move(rows));
  }
  const Objective& objective = problem_.objective();
  const double sign = objective.sense == Sense::Minimize ? 1 : -1;
  if (!auxiliary_) {
    return Program(std::move(columns), objective.response.function(), sign, scales_.objective,
                   std::move(rows));
  }
  columns.push_back({-kInfinity, kInfinity, auxiliary_start(start), scales_.objective});
  return Program(std::move(columns), variable_function(auxiliary), sign, scales_.objective,
                 std::move(rows));
}

}  // namespace camlaw::optim
