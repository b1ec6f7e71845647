// SPDX-License-Identifier: MIT
#include "fitting/motions/jump_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fitting/motions/motion_residuals.h"
#include "optim/fit/eigen_matrix.h"
#include "optim/fit/fit_report.h"

namespace camlaw::problems {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Looks for the gaps between places in which a motion begins and ends.
class GapSearch {
 public:
  GapSearch(const MotionSamples& samples, const optim::Residuals& residuals,
            const std::vector<optim::FitParameter>& parameters, Jumps jumps,
            const optim::FitOptions& options, optim::FitResult fit)
      : residuals_(residuals), given_(parameters), options_(options), best_(std::move(fit)) {
    options_.reach = optim::FitReach::Near;
    places_ = samples.place;
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    if (jumps.begin) ends_.push_back(MotionLayout::kBegin);
    if (jumps.end) ends_.push_back(MotionLayout::kEnd);
    for (const std::size_t end : ends_) gap_[end] = gap_of(best_.parameters[end].value);
  }

  optim::FitResult run() && {
    if (auto first = fit_in(gap_)) best_ = std::move(*first);
    constexpr int kParts = 32;  // of the samples: the first steps
    const int count = static_cast<int>(places_.size());
    for (int step = std::max(1, count / kParts); step > 0; step /= 2) {
      for (bool again = true; again;) {
        again = false;
        for (const Gaps& by : moves(step)) again = moved(by) || again;
      }
    }
    settle();
    add_what_jumps_tell();
    return std::move(best_);
  }

 private:
  using Gaps = std::array<int, 2>;

  /// The gap that a place lies in: from the place with that index to the next.
  int gap_of(double place) const {
    const auto next = std::upper_bound(places_.begin(), places_.end(), place);
    return static_cast<int>(next - places_.begin()) - 1;
  }
  bool is_gap(int gap) const { return gap >= 0 && gap + 1 < static_cast<int>(places_.size()); }
  double low(int gap) const { return places_[static_cast<std::size_t>(gap)]; }
  double high(int gap) const { return places_[static_cast<std::size_t>(gap) + 1]; }

  /// Shares of the gaps at which the ends are held; none: they are fitted within.
  using Shares = std::optional<std::array<double, 2>>;
  static constexpr std::array<double, 2> kMiddle{0.5, 0.5};

  /// The best fit with the ends in these gaps, from the best so far; none where that is not a
  /// motion.
  std::optional<optim::FitResult> fit_in(const Gaps& gaps, const Shares& shares = kMiddle) const {
    std::vector<optim::FitParameter> parameters = given_;
    for (std::size_t j = 0; j < parameters.size(); ++j) {
      parameters[j].start =
          std::clamp(best_.parameters[j].value, parameters[j].lower, parameters[j].upper);
    }
    for (const std::size_t end : ends_) {
      if (!is_gap(gaps[end])) return {};
      optim::FitParameter& p = parameters[end];
      const double from = low(gaps[end]), width = high(gaps[end]) - from;
      if (shares) {
        p.lower = p.upper = p.start = from + (*shares)[end] * width;
      } else {  // samples at the very ends belong to one side
        constexpr double kInside = 1e-6;
        p.lower = from + kInside * width, p.upper = from + (1 - kInside) * width;
        if (p.start < p.lower || p.start > p.upper) p.start = from + width / 2;
      }
    }
    if (parameters[MotionLayout::kEnd].start <= parameters[MotionLayout::kBegin].start) return {};
    try {
      return optim::fit(parameters, residuals_, options_);
    } catch (const std::invalid_argument&) {  // undefined there
      return {};
    }
  }

  /// Where in their gaps the ends lie: a jump between them may stand at a place.
  void settle() {
    constexpr std::array<double, 3> kShares{0.5, 0.25, 0.75};
    std::vector<Shares> tried{std::nullopt};
    for (const double first : kShares) {
      for (const double second : kShares) tried.push_back(std::array{first, second});
    }
    for (const Shares& shares : tried) {
      auto other = fit_in(gap_, shares);
      const bool is_better =
          other &&
          (other->merit < best_.merit * (1 - kSame) ||
           (other->converged && !best_.converged && other->merit <= best_.merit * (1 + kSame)));
      if (is_better) best_ = std::move(*other);
    }
  }

  /// Each end alone, and both: a jump between the ends stays where it is as they move apart.
  std::vector<Gaps> moves(int step) const {
    std::vector<Gaps> result;
    for (const std::size_t end : ends_) {
      for (const int by : {step, -step}) {
        Gaps gaps{};
        gaps[end] = by;
        result.push_back(gaps);
      }
    }
    if (ends_.size() < 2) return result;
    for (const int by : {step, -step}) {
      result.push_back({by, by});
      result.push_back({by, -by});
    }
    return result;
  }

  bool moved(const Gaps& by) {
    const Gaps gaps{gap_[0] + by[0], gap_[1] + by[1]};
    auto other = fit_in(gaps);
    if (!other || !(other->merit < best_.merit * (1 - kSame))) return false;
    best_ = std::move(*other);
    gap_ = gaps;
    return true;
  }

  /// The variance of an end by the jump alone: over gaps, each as likely as it is wide and as the
  /// fit within it is good.
  double variance_by_jump(std::size_t end) const {
    constexpr int kFar = 8;
    constexpr double kLeast = 1e-4;
    const double noise = best_.merit / std::max(1, best_.degrees_of_freedom);
    double weights = 0, sum = 0, squares = 0;
    const auto count = [&](int gap, double merit) {
      const double width = high(gap) - low(gap), middle = std::midpoint(low(gap), high(gap));
      const double share = noise > 0 ? std::exp(-(merit - best_.merit) / (2 * noise)) : 0;
      const double weight = width * (gap == gap_[end] ? 1 : share);
      weights += weight, sum += weight * middle;
      squares += weight * (middle * middle + width * width / 12);
      return share > kLeast;
    };
    count(gap_[end], best_.merit);
    for (const int side : {-1, 1}) {
      for (int k = 1; k <= kFar; ++k) {
        Gaps gaps = gap_;
        gaps[end] += side * k;
        const auto other = fit_in(gaps);
        if (!other || !count(gaps[end], other->merit)) break;
      }
    }
    const double mean = sum / weights;
    return std::max(squares / weights - mean * mean, 0.0);
  }

  /// Covariance and intervals by the residuals and the jumps together.
  void add_what_jumps_tell() {
    const auto n = static_cast<Index>(residuals_.count());
    const auto m = static_cast<Index>(given_.size());
    std::vector<double> p;
    for (const auto& parameter : best_.parameters) p.push_back(parameter.value);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(n, m);
    std::vector<double> r(static_cast<std::size_t>(n));
    if (!residuals_.evaluate(p, r, {jacobian.data(), static_cast<std::size_t>(n * m)})) return;
    const double variance = best_.sigma * best_.sigma;
    if (!(variance > 0)) return;
    MatrixXd information = jacobian.transpose() * jacobian / variance;
    for (const std::size_t end : ends_) {
      const auto j = static_cast<Index>(end);
      information(j, j) += 1 / variance_by_jump(end);
      best_.parameters[end].at_bound = false;
    }
    std::vector<Index> free;
    for (Index j = 0; j < m; ++j) {
      const auto& given = given_[static_cast<std::size_t>(j)];
      const bool held =
          given.lower == given.upper || best_.parameters[static_cast<std::size_t>(j)].at_bound;
      if (!held) free.push_back(j);
    }
    const MatrixXd own = information(free, free);
    const Eigen::VectorXd size = own.diagonal().cwiseSqrt().cwiseInverse();
    const MatrixXd scaled = size.asDiagonal() * own * size.asDiagonal();
    const Eigen::LDLT<MatrixXd> solved(scaled);
    constexpr double kSingular = 1e-12;
    if (!(solved.vectorD().minCoeff() > kSingular)) return;
    const MatrixXd inverse = solved.solve(MatrixXd::Identity(scaled.rows(), scaled.cols()));
    best_.covariance = optim::SquareMatrix(static_cast<std::size_t>(m));
    optim::as_eigen(best_.covariance)(free, free) = size.asDiagonal() * inverse * size.asDiagonal();
    // What the residuals alone leave open the jumps settle.
    best_.free_directions.clear();
    for (auto& parameter : best_.parameters) parameter.identifiable = true;
    best_.rank = free.size();
    if (best_.converged) best_.reason = best_.reason_but_bounds = "";
    optim::set_intervals(given_, options_.confidence, best_);
  }

  static constexpr double kSame = 1e-9;

  const optim::Residuals& residuals_;
  const std::vector<optim::FitParameter>& given_;
  optim::FitOptions options_;
  optim::FitResult best_;
  std::vector<double> places_;
  std::vector<std::size_t> ends_;
  Gaps gap_{};
};

}  // namespace

optim::FitResult fit_with_jumps(const MotionSamples& samples, const optim::Residuals& residuals,
                                const std::vector<optim::FitParameter>& parameters, Jumps jumps,
                                const optim::FitOptions& options, optim::FitResult fit) {
  if (!jumps.any()) return fit;
  return GapSearch(samples, residuals, parameters, jumps, options, std::move(fit)).run();
}

}  // namespace camlaw::problems
