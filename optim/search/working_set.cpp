// SPDX-License-Identifier: MIT
#include "optim/search/working_set.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "optim/search/exchange.h"

namespace camlaw::optim {
namespace {

/// Whether a place is in the set but for rounding: asking again would not move the solver.
bool is_known(const CurveSide& side, Place place, const std::vector<double>& breaks) {
  const double near = 1e-10 * (breaks.back() - breaks.front());
  return std::any_of(side.places.begin(), side.places.end(), [&](const Place& other) {
    return other.from_left == place.from_left && other.joint == place.joint &&
           (place.joint >= 0 || std::abs(other.angle - place.angle) <= near);
  });
}

/// Of each stretch. Few stretches get more places each: the first program should already be
/// bounded.
int steps_at_first(std::size_t breaks) {
  constexpr std::size_t kFewStretches = 16;
  return breaks <= kFewStretches ? 8 : 2;
}

/// Tells rows that say the same: where a linear curve is level, or joins smoothly, neighbouring
/// places of it give one row.
class Repeats {
 public:
  Repeats(const Curve& curve, Design x)
      : curve_(curve), x_(x), tells_(curve.shape() == Shape::Linear && !curve.breaks_move()) {}

  /// Whether one of the last few places that were not repeats has the row of this one.
  bool operator()(Place place) {
    if (!tells_) return false;
    Line line = line_at(place);
    const bool repeats = std::any_of(latest_.begin(), latest_.end(),
                                     [&](const Line& other) { return alike(line, other); });
    if (!repeats) {
      latest_[next_] = std::move(line);
      next_ = (next_ + 1) % latest_.size();
    }
    return repeats;
  }

 private:
  /// A linear function: its value at the design and its slopes.
  struct Line {
    double value = 0;
    std::vector<std::size_t> inputs;
    std::vector<double> slopes;

    double slope(std::size_t input) const {
      const auto at = std::lower_bound(inputs.begin(), inputs.end(), input);
      const bool there = at != inputs.end() && *at == input;
      return there ? slopes[static_cast<std::size_t>(at - inputs.begin())] : 0;
    }
  };

  Line line_at(Place place) const {
    const Function function = curve_.at(place);
    Line line{0, function.inputs(), std::vector<double>(function.inputs().size())};
    line.value = function.gradient(x_, line.slopes);
    return line;
  }

  /// To rounding, slopes that vanish but for rounding included.
  static bool alike(const Line& a, const Line& b) {
    constexpr double kRounding = 1e-12;
    double steepest = 0;
    for (const double slope : a.slopes) steepest = std::max(steepest, std::abs(slope));
    const double slack = kRounding * steepest;
    const auto all_near = [&](const Line& one, const Line& other) {
      for (std::size_t k = 0; k < one.inputs.size(); ++k) {
        if (!(std::abs(one.slopes[k] - other.slope(one.inputs[k])) <= slack)) return false;
      }
      return true;
    };
    return steepest > 0 && std::abs(a.value - b.value) <= slack && all_near(a, b) && all_near(b, a);
  }

  const Curve& curve_;
  Design x_;
  bool tells_;
  std::array<Line, 4> latest_;
  std::size_t next_ = 0;
};

}  // namespace

std::size_t places_at_first(std::size_t breaks) {
  return (breaks - 1) * static_cast<std::size_t>(steps_at_first(breaks) + 1);
}

WorkingSet::WorkingSet(const Problem& problem, const Sizes& sizes, Aim aim)
    : problem_(problem),
      sizes_(sizes),
      aim_(aim),
      auxiliary_(aim == Aim::LeastViolation || problem.objective().response.is_curve()) {
  const Objective& objective = problem.objective();
  if (aim == Aim::Optimum && objective.response.is_curve()) {
    const auto add = [&](double sign) {
      sides_.push_back({&objective.response,
                        sign,
                        0,
                        true,
                        sizes.objective,
                        sizes.objective_tolerance,
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
    const ConstraintSize& size = sizes.constraints[i];
    const auto add = [&](double sign, double bound) {
      add_side({&c.response, sign, bound, false, size.size, size.tolerance, i, {}, {}}, known);
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
  if (side.of_peak || aim_ == Aim::LeastViolation) return {};
  return RestWeights(side.response->curve(), side.bound, x);
}

void WorkingSet::begin_at(Design x) {
  for (CurveSide& side : sides_) begin_side(side, x);
}

void WorkingSet::begin_side(CurveSide& side, Design x) {
  const Curve& curve = side.response->curve();
  const RestWeights weights = weights_of(side, x);
  std::size_t number = 0;
  for (const Rest& rest : weights.rests()) {
    const double size = typical_change(rest.leading, x, sizes_.variables);
    if (size > 0 && std::isfinite(size))
      rests_.push_back({rest.leading, side.sign, size, *side.constraint, number});
    ++number;
  }
  const auto is_moved = [&](Place place) {
    if (side.of_peak || aim_ == Aim::LeastViolation) return true;
    const double slope = typical_change(curve.at(place), x, sizes_.variables);
    return !vanishes(slope / (side.size * weights.at(place)));
  };
  const auto breaks = curve.trace(x)->breaks();
  const int steps = steps_at_first(breaks.size());
  Repeats repeats(curve, x);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (int i = 0; i <= steps; ++i) {
      const Place place = curve.tied(even_place(breaks[k], breaks[k + 1], steps, i), x);
      if (weights.is_rest(place) || !is_moved(place) || repeats(place)) continue;
      side.places.push_back(place);
      side.weights.push_back(weights.at(place));
    }
  }
}

std::size_t WorkingSet::add_violated(Design x, double auxiliary, double share) {
  std::size_t added = 0;
  for (CurveSide& side : sides_) {
    const double slack = aim_ == Aim::LeastViolation ? side.size * auxiliary : 0;
    const double bound = side.of_peak ? auxiliary : side.bound;
    // A minimised peak is bounded from above by the auxiliary, a maximised lowest value from below,
    // a magnitude from both sides.
    const double limit =
        side.of_peak && problem_.objective().part == Part::Magnitude ? bound : side.sign * bound;
    const Curve& curve = side.response->curve();
    const auto trace = curve.trace(x);
    const RestWeights weights = weights_of(side, x);
    for (const Extreme& peak : local_maxima(*trace, side.sign)) {
      const double above = side.sign * peak.value - limit - slack;
      if (!(above > share * side.tolerance)) continue;
      const Place place = curve.tied(peak.place, x);
      if (weights.is_rest(place) || is_known(side, place, trace->breaks())) continue;
      side.places.push_back(place);
      side.weights.push_back(weights.at(place));
      ++added;
    }
  }
  return added;
}

Row WorkingSet::number_row(std::size_t constraint) const {
  const Constraint& c = problem_.constraints[constraint];
  return {.function = c.response.function(),
          .lower = c.lower.value_or(-kInfinity),
          .upper = c.upper.value_or(kInfinity),
          .size = sizes_.constraints[constraint].size,
          .constraint = constraint};
}

void WorkingSet::add_rows(std::vector<Row>& rows) const {
  const std::size_t auxiliary = problem_.variables.size();
  for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
    const Constraint& c = problem_.constraints[i];
    if (c.response.is_curve()) continue;
    const Row row = number_row(i);
    if (aim_ == Aim::Optimum) {
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
    for (std::size_t k = 0; k < side.places.size(); ++k) {
      Row row{.function = side.response->curve().at(side.places[k]),
              .size = side.size * side.weights[k],
              .constraint = side.constraint,
              .place = side.places[k]};
      const bool magnitude = side.of_peak && problem_.objective().part == Part::Magnitude;
      (side.sign > 0 ? row.upper : row.lower) = side.of_peak ? 0 : side.bound;
      if (side.of_peak) row.auxiliary = {{auxiliary, magnitude && side.sign < 0 ? 1.0 : -1.0}};
      if (aim_ == Aim::LeastViolation) row.auxiliary = {{auxiliary, -side.sign * side.size}};
      rows.push_back(std::move(row));
    }
  }
}

std::vector<std::size_t> WorkingSet::row_groups() const {
  std::size_t numbers = rests_.size();
  for (const Constraint& c : problem_.constraints) {
    if (c.response.is_curve()) continue;
    const bool both = aim_ == Aim::LeastViolation && c.lower && c.upper;
    numbers += both ? 2 : 1;
  }
  std::vector<std::size_t> groups{numbers};
  for (const CurveSide& side : sides_) groups.push_back(side.places.size());
  return groups;
}

double WorkingSet::auxiliary_start(Design x) const {
  if (aim_ == Aim::Optimum) return objective_value(problem_.objective(), x);
  return std::max(0.0, largest_violation(problem_, sizes_, x));
}

Program WorkingSet::program(Design start) const {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < problem_.variables.size(); ++i) {
    const Variable& v = problem_.variables[i];
    columns.push_back({v.lower, v.upper, start[i], sizes_.variables[i]});
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
    return Program(std::move(columns), objective.response.function(), sign, sizes_.objective,
                   std::move(rows));
  }
  columns.push_back({-kInfinity, kInfinity, auxiliary_start(start), sizes_.objective});
  return Program(std::move(columns), variable_function(auxiliary), sign, sizes_.objective,
                 std::move(rows));
}

}  // namespace camlaw::optim
