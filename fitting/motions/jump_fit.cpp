// SPDX-License-Identifier: MIT
#include "fitting/motions/jump_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/motion_residuals.h"
#include "numerics/linear/dense.h"
#include "optim/fit/eigen_matrix.h"
#include "optim/fit/fit_report.h"

namespace camlaw::problems {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The gaps that begin and end lie in: each from the place with that index to the next.
using Gaps = std::array<int, 2>;
/// Shares of the gaps at which the ends are held; without a value they are fitted inside the gaps.
using Shares = std::optional<std::array<double, 2>>;
constexpr std::array<double, 2> kMiddle{0.5, 0.5};
constexpr double kSameMerit = 1e-9;  // of the sum: fits that end at one place differ by rounding

/// What is fitted, and the places that an end with a jump lies between.
struct Jumping {
  const optim::Residuals& residuals;
  const FitParameters& given;
  const optim::FitOptions& options;
  std::vector<double> places;     ///< increasing
  std::vector<std::size_t> ends;  ///< of the parameters: those with a jump

  bool is_gap(int gap) const { return gap >= 0 && gap + 1 < static_cast<int>(places.size()); }
  double low(int gap) const { return places[static_cast<std::size_t>(gap)]; }
  double high(int gap) const { return places[static_cast<std::size_t>(gap) + 1]; }
};

struct InGaps {
  optim::FitResult fit;
  Gaps gaps;
};

/// The best fit with the ends in these gaps, from another; none where that is not a motion.
std::optional<optim::FitResult> fit_in(const Jumping& jumping, const optim::FitResult& from,
                                       const Gaps& gaps, const Shares& shares = kMiddle) {
  FitParameters parameters = starting_at(jumping.given, values_of(from));
  for (const std::size_t end : jumping.ends) {
    if (!jumping.is_gap(gaps[end])) return {};
    optim::FitParameter& p = parameters[end];
    const double low = jumping.low(gaps[end]), width = jumping.high(gaps[end]) - low;
    if (shares) {
      p.lower = p.upper = p.start = low + (*shares)[end] * width;
    } else {  // samples at the very ends belong to one side
      constexpr double kInside = 1e-6;
      p.lower = low + kInside * width, p.upper = low + (1 - kInside) * width;
      if (p.start < p.lower || p.start > p.upper) p.start = low + width / 2;
    }
  }
  if (parameters[MotionLayout::kEnd].start <= parameters[MotionLayout::kBegin].start) return {};
  return optim::possible_fit(parameters, jumping.residuals, jumping.options).if_any();
}

/// Each end alone, and both: a jump between the ends stays where it is as they move apart.
std::vector<Gaps> moves(const Jumping& jumping, int step) {
  std::vector<Gaps> result;
  for (const std::size_t end : jumping.ends) {
    for (const int by : {step, -step}) {
      Gaps gaps{};
      gaps[end] = by;
      result.push_back(gaps);
    }
  }
  if (jumping.ends.size() < 2) return result;
  for (const int by : {step, -step}) {
    result.push_back({by, by});
    result.push_back({by, -by});
  }
  return result;
}

/// The gaps with the best fit, in steps that become shorter.
InGaps best_gaps(const Jumping& jumping, InGaps best) {
  if (auto first = fit_in(jumping, best.fit, best.gaps)) best.fit = std::move(*first);
  constexpr int kParts = 32;  // of the samples: the first steps
  const int count = static_cast<int>(jumping.places.size());
  for (int step = std::max(1, count / kParts); step > 0; step /= 2) {
    for (bool again = true; again;) {
      again = false;
      for (const Gaps& by : moves(jumping, step)) {
        const Gaps gaps{best.gaps[0] + by[0], best.gaps[1] + by[1]};
        auto other = fit_in(jumping, best.fit, gaps);
        if (!other || !(other->merit < best.fit.merit * (1 - kSameMerit))) continue;
        best = {std::move(*other), gaps};
        again = true;
      }
    }
  }
  return best;
}

/// Where in their gaps the ends lie: a jump between them may stand at a place.
optim::FitResult settled(const Jumping& jumping, InGaps in) {
  constexpr std::array<double, 3> kShares{0.5, 0.25, 0.75};
  std::vector<Shares> tried{std::nullopt};
  for (const double first : kShares) {
    for (const double second : kShares) tried.push_back(std::array{first, second});
  }
  for (const Shares& shares : tried) {
    auto other = fit_in(jumping, in.fit, in.gaps, shares);
    const bool is_better = other && (other->merit < in.fit.merit * (1 - kSameMerit) ||
                                     (other->converged && !in.fit.converged &&
                                      other->merit <= in.fit.merit * (1 + kSameMerit)));
    if (is_better) in.fit = std::move(*other);
  }
  return std::move(in.fit);
}

/// The variance of an end by the jump alone: over gaps, each as likely as it is wide and as the fit
/// within it is good.
double variance_by_jump(const Jumping& jumping, const InGaps& best, std::size_t end) {
  // Gaps to either side: an end is known to a few where it can be told at all.
  constexpr int kFar = 8;
  // Of all likelihood: farther gaps add nothing to a variance that is told with two digits.
  constexpr double kLeast = 1e-4;
  const double noise = best.fit.merit / std::max(1, best.fit.degrees_of_freedom);
  double weights = 0, sum = 0, squares = 0;
  const auto count = [&](int gap, double merit) {
    const double low = jumping.low(gap), high = jumping.high(gap);
    const double width = high - low, middle = std::midpoint(low, high);
    const double share = noise > 0 ? std::exp(-(merit - best.fit.merit) / (2 * noise)) : 0;
    const double weight = width * (gap == best.gaps[end] ? 1 : share);
    weights += weight, sum += weight * middle;
    squares += weight * (middle * middle + width * width / 12);
    return share > kLeast;
  };
  count(best.gaps[end], best.fit.merit);
  for (const int side : {-1, 1}) {
    for (int k = 1; k <= kFar; ++k) {
      Gaps gaps = best.gaps;
      gaps[end] += side * k;
      const auto other = fit_in(jumping, best.fit, gaps);
      if (!other || !count(gaps[end], other->merit)) break;
    }
  }
  const double mean = sum / weights;
  return std::max(squares / weights - mean * mean, 0.0);
}

/// The fit with covariance and intervals by the residuals and the jumps together.
optim::FitResult with_what_jumps_tell(const Jumping& jumping, const InGaps& best) {
  const auto n = static_cast<Index>(jumping.residuals.count());
  const auto m = static_cast<Index>(jumping.given.size());
  optim::FitResult fit = best.fit;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(n, m);
  std::vector<double> r(static_cast<std::size_t>(n));
  const std::span<double> rows(jacobian.data(), static_cast<std::size_t>(n * m));
  if (!jumping.residuals.evaluate(values_of(fit), r, rows)) return fit;
  const double variance = fit.sigma * fit.sigma;
  if (!(variance > 0)) return fit;
  MatrixXd information = jacobian.transpose() * jacobian / variance;
  for (const std::size_t end : jumping.ends) {
    const auto j = static_cast<Index>(end);
    information(j, j) += 1 / variance_by_jump(jumping, best, end);
    fit.parameters[end].at_bound = false;
  }
  std::vector<Index> free;
  for (Index j = 0; j < m; ++j) {
    const auto at = static_cast<std::size_t>(j);
    if (!is_held(jumping.given[at]) && !fit.parameters[at].at_bound) free.push_back(j);
  }
  const MatrixXd own = information(free, free);
  const Eigen::VectorXd size = own.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = size.asDiagonal() * own * size.asDiagonal();
  // With columns of length one: beyond it an inverse has no digits that count.
  constexpr double kSingular = 1e-12;
  const auto inverse = optim::positive_definite_inverse(scaled, kSingular);
  if (!inverse) return fit;
  fit.covariance = optim::SquareMatrix(static_cast<std::size_t>(m));
  optim::as_eigen(fit.covariance)(free, free) = size.asDiagonal() * *inverse * size.asDiagonal();
  // What the residuals alone leave open the jumps settle.
  fit.free_directions.clear();
  for (auto& parameter : fit.parameters) parameter.identifiable = true;
  fit.rank = free.size();
  if (fit.converged) fit.reason = fit.reason_but_bounds = "";
  optim::set_intervals(jumping.given, jumping.options.confidence, fit);
  return fit;
}

}  // namespace

optim::FitResult fit_with_jumps(const MotionSamples& samples, const optim::Residuals& residuals,
                                const std::vector<optim::FitParameter>& parameters, EndJumps jumps,
                                const optim::FitOptions& options, optim::FitResult fit) {
  if (!jumps.any()) return fit;
  optim::FitOptions near = options;
  near.reach = optim::FitReach::Near;
  Jumping jumping{residuals, parameters, near, samples.place, {}};
  std::vector<double>& places = jumping.places;
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (jumps.begin) jumping.ends.push_back(MotionLayout::kBegin);
  if (jumps.end) jumping.ends.push_back(MotionLayout::kEnd);
  InGaps best{std::move(fit), {}};
  for (const std::size_t end : jumping.ends) {
    const double place = best.fit.parameters[end].value;
    const auto next = std::upper_bound(places.begin(), places.end(), place);
    best.gaps[end] = static_cast<int>(next - places.begin()) - 1;
  }
  best = best_gaps(jumping, std::move(best));
  best.fit = settled(jumping, best);
  return with_what_jumps_tell(jumping, best);
}

}  // namespace camlaw::problems
