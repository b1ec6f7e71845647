// SPDX-License-Identifier: MIT
#include "optim/cycle/scales.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "optim/cycle/maxima_at.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

double or_one(double size) { return size > 0 && std::isfinite(size) ? size : 1; }

/// Scales of what varies; zero for what is fixed.
std::vector<double> free_scales(const Problem& problem, std::vector<double> scales) {
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if (problem.variables[i].lower == problem.variables[i].upper) scales[i] = 0;
  }
  return scales;
}

/// Designs that fill a neighbourhood of one evenly, `reach` typical changes wide to each side.
std::vector<std::vector<double>> neighbours(const Problem& problem, Design about,
                                            const std::vector<double>& scales, double reach,
                                            int count) {
  Problem near;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    Variable v = problem.variables[i];
    v.start = std::clamp(about[i], v.lower, v.upper);
    v.lower = std::max(v.lower, v.start - reach * scales[i]);
    v.upper = std::min(v.upper, v.start + reach * scales[i]);
    near.variables.push_back(std::move(v));
  }
  auto designs = starts(near, count + 1, 1);
  designs.erase(designs.begin());
  return designs;
}

/// How large a response is at a design: of a curve its highest |value|, of a number what its
/// variables contribute to it, to first order.
double magnitude(const Response& response, MaximaAt& maxima, Design x,
                 const std::vector<double>& own) {
  if (response.is_curve()) {
    return std::abs(maxima.extreme_of(response.curve(), Part::Magnitude).value);
  }
  const Function& f = response.function();
  std::vector<double> g(f.inputs().size());
  f.gradient(x, g);
  double sum = 0;
  for (std::size_t k = 0; k < g.size(); ++k) sum += std::abs(g[k]) * own[f.inputs()[k]];
  return sum;
}

/// Zero where there are no values.
double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What typical changes make of responses at one design and about it.
class Changes {
 public:
  Changes(const Problem& problem, Design about)
      : problem_(problem),
        scales_(free_scales(problem, typical_scales(problem, about))),
        about_(about.begin(), about.end()) {
    // With more variables, the slopes at eight designs take long.
    constexpr std::size_t kSampled = 300;
    constexpr int kFewDesigns = 2;  // of many variables, for curves alone
    const bool many = scales_.size() > kSampled;
    const Response& sought = problem.objective().response;
    if (many && !sought.is_curve()) return;
    box_ = neighbours(problem, about, scales_, 1, many ? kFewDesigns : kDesigns);
    samples_changes_ = !many;
  }

  /// About the design: the median of what is a number and not zero; zero where there is none.
  double typical(const Response& response) const {
    // What is linear, and changes nowhere else, changes alike at every design.
    if (!samples_changes_) return 0;
    if (is_alike(response)) return or_zero(typical_change(response, about_, scales_));
    return typical_among(box_, response);
  }

  /// The same of an objective, as far as it is steep.
  double typical_near(const Objective& objective) const {
    const double whole = typical(objective.response);
    if (!samples_changes_ || is_alike(objective.response)) return whole;
    const double value = std::abs(objective_value(objective, about_));
    return narrowed(whole, value, [&](const auto& designs) {
      return typical_among(designs, objective.response);
    });
  }

  /// How large a curve is: its highest |value| at the design or, where that is more, the median of
  /// those about it (a curve may be brought to zero); zero where it is not a number.
  double whole(const Response& curve, MaximaAt& here, const std::vector<double>& own) const {
    const double about = samples_changes_ ? largest_among(box_, curve) : 0;
    return std::max(about, magnitude_here(curve, here, own));
  }

  /// The same of an objective: of what lies about a share, as far as it is steep.
  double sought(const Response& curve, MaximaAt& here, const std::vector<double>& own) const {
    constexpr double kLeast = 1e-3;  // less is nearer to zero than solvers come
    const auto n = static_cast<double>(
        std::count_if(scales_.begin(), scales_.end(), [](double scale) { return scale > 0; }));
    const double share = std::max(kLeast, 1 / std::max(1.0, n * n));
    const double size = magnitude_here(curve, here, own);
    const double about = narrowed(largest_among(box_, curve), size, [&](const auto& designs) {
      return largest_among(designs, curve);
    });
    return std::max(share * about, size);
  }

  double at_design(const Response& response) const {
    return at_design(response, is_alike(response) ? 0 : typical(response));
  }
  double at_design(const Objective& objective, double typical) const {
    return at_design(objective.response, is_alike(objective.response) ? 0 : typical);
  }

 private:
  static constexpr int kDesigns = 8;

  double at_design(const Response& response, double usual) const {
    // A change of 0 at a stationary point, or without end beside a pole, is no scale.
    constexpr double kFar = 100;
    const double here = typical_change(response, about_, scales_);
    if (usual == 0) return here;
    return here > 0 ? std::clamp(here, usual / kFar, usual * kFar) : usual;
  }

  /// The median of what is a number and not zero; zero where there is none.
  double typical_among(const std::vector<std::vector<double>>& designs,
                       const Response& response) const {
    std::vector<double> changes;
    for (const auto& x : designs) {
      const double change = typical_change(response, x, scales_);
      if (change > 0 && std::isfinite(change)) changes.push_back(change);
    }
    return median(std::move(changes));
  }

  /// What a measure of designs about is, `whole` in the neighbourhood of typical changes. A steep
  /// function, such as exp(40 q), and its slopes grow there by orders of magnitude: then what lies
  /// nearer counts, in ever narrower neighbourhoods, enlarged as if it grew with the distance.
  template <class Measure>
  double narrowed(double whole, double here, const Measure& of) const {
    constexpr double kSteep = 10;  // times the value: less is not steep
    constexpr double kNarrower = 4;
    constexpr int kNeighbourhoods = 5;  // the last is a thousandth as wide
    if (!samples_changes_ || whole <= kSteep * here) return whole;
    double least = whole, reach = 1;
    for (int i = 0; i < kNeighbourhoods; ++i) {
      reach /= kNarrower;
      const double enlarged = of(neighbours(problem_, about_, scales_, reach, kDesigns)) / reach;
      if (enlarged > 0) least = std::min(least, enlarged);
    }
    return least;
  }

  static bool is_alike(const Response& response) {
    const bool moves = response.is_curve() && response.curve().breaks_move();
    return response.shape() == Shape::Linear && !moves;
  }
  static double or_zero(double change) { return std::isfinite(change) ? change : 0; }

  static double largest_among(const std::vector<std::vector<double>>& designs,
                              const Response& curve) {
    std::vector<double> values;
    for (const auto& x : designs) {
      const double value = curve.curve().largest(x);
      if (std::isfinite(value)) values.push_back(value);
    }
    return median(std::move(values));
  }
  double magnitude_here(const Response& curve, MaximaAt& here,
                        const std::vector<double>& own) const {
    return or_zero(magnitude(curve, here, about_, own));
  }

  const Problem& problem_;
  std::vector<double> scales_, about_;
  std::vector<std::vector<double>> box_;
  bool samples_changes_ = false;
};

double larger_bound(const Constraint& c) {
  return std::max(std::abs(c.lower.value_or(0)), std::abs(c.upper.value_or(0)));
}

void set_tolerance(const Constraint& c, MaximaAt& maxima, Design x, const std::vector<double>& own,
                   ConstraintScale& its) {
  constexpr double kShare = 1e-6;     // of the bound, or of the size of what acts (SC3)
  constexpr double kNearZero = 1e-3;  // of the response: a bound below this is as good as zero
  constexpr double kCancels = 1e-6;   // of typical changes of a curve: rounding leaves so much
  const double bound = larger_bound(c), whole = magnitude(c.response, maxima, x, own);
  const double least = c.response.is_curve() && !c.scale ? kCancels * its.scale : 0;
  const double usual =
      kShare * (bound > 0 ? std::max(bound, std::isfinite(whole) ? kNearZero * whole : 0)
                          : or_one(std::max(whole, least)));
  its.tolerance = c.tolerance.value_or(usual);
  its.default_tolerance = std::min(usual, its.tolerance);
}

/// What is known of each curve, which many limits may be on.
struct CurveChange {
  double at_design, here;
  std::optional<double> whole;  ///< worked out where it decides
};
using CurveChanges = std::map<const Curve*, CurveChange>;

/// Of a curve no more than a hundred times what it is and may be: what changes by more stands
/// beside a pole, and its slope is not the size of anything.
double size_of(const Constraint& c, const Changes& changes, MaximaAt& maxima,
               const std::vector<double>& own, CurveChanges& known) {
  constexpr double kLeast = 1e-3, kMost = 100;  // of the bound; of bound and highest |value|
  if (c.scale) return *c.scale;
  const double bound = larger_bound(c);
  if (!c.response.is_curve()) {
    return or_one(std::max(changes.at_design(c.response), kLeast * bound));
  }
  auto curve = known.find(&c.response.curve());
  if (curve == known.end()) {
    const double here = magnitude(c.response, maxima, {}, own);
    const CurveChange fresh{changes.at_design(c.response), std::isfinite(here) ? here : 0, {}};
    curve = known.emplace(&c.response.curve(), fresh).first;
  }
  CurveChange& its = curve->second;
  const double change = std::max(its.at_design, kLeast * bound);
  if (change <= kMost * std::max(bound, its.here)) return or_one(change);
  if (!its.whole) its.whole = changes.whole(c.response, maxima, own);
  const double whole = std::max(bound, *its.whole);
  return or_one(whole > 0 ? std::min(change, kMost * whole) : change);
}

/// What a change of the objective is a share of where its value is near zero: a typical change, of
/// a curve no more than how large it is. Beside a pole, such as the acceleration of a phase that
/// hardly lasts, a slope says nothing of that. Designs about one by all n variables are rougher the
/// more there are, by n^2 where the curve is a second derivative: 1 / n^2 of theirs counts.
double objective_typical(const Objective& objective, double typical, const Changes& changes,
                         MaximaAt& maxima, const std::vector<double>& own) {
  if (!objective.response.is_curve()) return typical;
  const double whole = changes.sought(objective.response, maxima, own);
  return whole > 0 ? std::min(typical, whole) : typical;
}

double objective_tolerance(const Objective& objective, double typical, Design x) {
  constexpr double kShare = 1e-7;  // as the conditions of optimality have to hold (SC3)
  if (objective.tolerance) return *objective.tolerance;
  const double value = objective_value(objective, x);
  // A proof of a peak takes the longer the nearer its tolerance is to rounding.
  const bool is_near_zero = objective.response.is_curve() && !(std::abs(value) >= typical);
  return kShare * (is_near_zero ? typical : objective_size(objective, typical, value));
}

/// Highest value of sign * number or curve at a design.
double peak_of(const Response& response, double sign, MaximaAt& maxima, Design x) {
  if (!response.is_curve()) return sign * response.function().value(x);
  return sign * maxima.highest(response.curve(), sign).value;
}

/// How far a limit is broken, in its response's unit; below 0 where it has room.
double violation(const Constraint& c, MaximaAt& maxima, Design x) {
  const double above = c.upper ? peak_of(c.response, 1, maxima, x) - *c.upper : -kInfinity;
  const double below = c.lower ? peak_of(c.response, -1, maxima, x) + *c.lower : -kInfinity;
  return std::max(above, below);
}

}  // namespace

double typical_change(const Function& function, Design x, const std::vector<double>& scales) {
  std::vector<double> g(function.inputs().size());
  function.gradient(x, g);
  double largest = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double change = std::abs(g[k]) * scales[function.inputs()[k]];
    if (std::isfinite(change)) largest = std::max(largest, change);
  }
  return largest;
}

double typical_change(const Response& response, Design x, const std::vector<double>& scales) {
  if (!response.is_curve()) return typical_change(response.function(), x, scales);
  constexpr int kPlaces = 5;       // in each smooth stretch
  constexpr double kShort = 1e-6;  // of the cycle: what goes on in less has no size of its own
  if (const auto known = response.curve().largest_change(scales, kPlaces, kShort)) return *known;
  const auto breaks = response.curve().trace(x)->breaks();
  const double shortest = kShort * (breaks.back() - breaks.front());
  double largest = 0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (breaks[k + 1] - breaks[k] < shortest) continue;
    for (int i = 0; i < kPlaces; ++i) {
      const double angle = breaks[k] + (breaks[k + 1] - breaks[k]) * (i + 0.5) / kPlaces;
      largest = std::max(largest, typical_change(response.curve().at({angle}), x, scales));
    }
  }
  return largest;
}

double objective_value(const Objective& objective, Design x) {
  if (!objective.response.is_curve()) return objective.response.function().value(x);
  const double value = extreme_of(*objective.response.curve().trace(x), objective.part).value;
  return objective.part == Part::Magnitude ? std::abs(value) : value;
}

double objective_size(const Objective& objective, double typical, double value) {
  // Of a least sum of squares, which is 0, methods reach designs to within 1e-11 of the variables:
  // its slopes are then less than 1e-7 of this. A peak is 0 where a curve vanishes, which methods
  // reach to what they leave of its many rows.
  constexpr double kOfNumber = 1e-4, kOfPeak = 0.1;
  const double least = (objective.response.is_curve() ? kOfPeak : kOfNumber) * typical;
  return std::isfinite(value) ? std::max(std::abs(value), least) : least;
}

double largest_violation(const Problem& problem, const Scales& scales, Design x) {
  MaximaAt maxima(x);
  double worst = -kInfinity;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const double over = violation(problem.constraints[i], maxima, x);
    worst = std::max(worst, over / scales.constraints[i].scale);
  }
  return worst;
}

Scales broken_alike(const Problem& problem, Scales scales, Design x) {
  const double share = largest_violation(problem, scales, x);
  if (!(share > 0) || std::isinf(share)) return scales;
  MaximaAt maxima(x);
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const double over = violation(problem.constraints[i], maxima, x);
    if (over > scales.constraints[i].tolerance) scales.constraints[i].scale = over / share;
  }
  return scales;
}

std::vector<double> own_magnitudes(const Problem& problem, Design x) {
  std::vector<double> result;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const Variable& v = problem.variables[i];
    const double range = v.upper > v.lower ? v.upper - v.lower : kInfinity;
    result.push_back(v.scale.value_or(std::max(std::abs(x[i]), std::min(1.0, range))));
  }
  return result;
}

std::vector<double> typical_scales(const Problem& problem, Design x) {
  std::vector<double> result = own_magnitudes(problem, x);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Variable& v = problem.variables[i];
    if (!v.scale && v.upper > v.lower) result[i] = std::min(result[i], v.upper - v.lower);
  }
  return result;
}

Scales scales(const Problem& problem, Design about) {
  const Changes changes(problem, about);
  MaximaAt maxima(about);
  CurveChanges known;
  const Objective& objective = problem.objective();
  Scales result;
  result.variables = typical_scales(problem, about);
  result.own = own_magnitudes(problem, about);
  const double typical = changes.typical_near(objective);
  result.objective = or_one(changes.at_design(objective, typical));
  result.objective_typical = objective_typical(objective, typical > 0 ? typical : result.objective,
                                               changes, maxima, result.own);
  result.objective_tolerance = objective_tolerance(objective, result.objective_typical, about);
  for (const Constraint& c : problem.constraints) {
    result.constraints.push_back({size_of(c, changes, maxima, result.own, known), 0, 0});
    set_tolerance(c, maxima, about, result.own, result.constraints.back());
  }
  return result;
}

Scales judged_at(const Problem& problem, Scales scales, Design x) {
  scales.own = own_magnitudes(problem, x);
  scales.objective_tolerance =
      objective_tolerance(problem.objective(), scales.objective_typical, x);
  MaximaAt maxima(x);
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    set_tolerance(problem.constraints[i], maxima, x, scales.own, scales.constraints[i]);
  }
  return scales;
}

}  // namespace camlaw::optim
