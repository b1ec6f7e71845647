// SPDX-License-Identifier: MIT
#include "numerics/linear/bounded_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "numerics/linear/bounded_problem.h"
#include "numerics/linear/interior_point.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// Factorizations after which the search starts afresh from an interior point, which takes some 25
/// to 70, and after which it ends from there. Where no columns are nearly alike, up to 32 were seen
/// at 20000 columns; where thousands are, the search clamped them one by one from an interior point
/// whose square was 4e-4 above the least.
constexpr int kIdleSteps = 64;

/// Lawson and Hanson's method (1974, chapter 23), many columns at a time: a set of columns in play
/// is fitted; columns that the fit would turn negative are clamped; clamped columns that pull are
/// put in play again. Each round must lower |A m + b| by more than rounding, and ends at the least
/// over the columns in play, so no set comes twice. Dependent columns stay in play, fitted by those
/// that are independent.
class Search {
 public:
  Search(const BoundedProblem& problem, Factorize factorize)
      : problem_(problem), factorize_(factorize), factor_(factorize(problem.A())) {
    state_.columns.assign(problem.free().size(), ColumnState::Clamped);
    state_.point = problem.at(VectorXd::Zero(problem.A().cols()));
  }

  void run() {
    std::vector<int> all(state_.columns.size());
    std::iota(all.begin(), all.end(), 0);
    gain_by(all);
    follow_pulls();
    if (factorizations_ < patience_) return;
    start_amid();
    follow_pulls();
  }

  LeastSquaresResult result() const {
    LeastSquaresResult result;
    result.multipliers.assign(state_.point.m.begin(), state_.point.m.end());
    result.columns = state_.columns;
    for (std::size_t j = 0; j < result.columns.size(); ++j) {
      // A free column starts like the others, and stays so where there is nothing to gain.
      const bool idle = problem_.free()[j] && result.columns[j] == ColumnState::Clamped;
      if (idle) result.columns[j] = ColumnState::InPlay;
    }
    result.condition = condition_;
    result.factorizations = factorizations_;
    return result;
  }

 private:
  struct State {
    BoundedPoint point;
    std::vector<ColumnState> columns;
  };

  ColumnState& column(Index j) { return state_.columns[static_cast<std::size_t>(j)]; }

  void follow_pulls() {
    std::vector<int> pulling = pulling_columns();
    while (!pulling.empty() && factorizations_ < patience_) {
      if (gain_by(pulling)) {
        pulling = pulling_columns();
      } else {
        // Pulls of rounding's size may spoil the others; the strongest go last.
        pulling.resize(pulling.size() / 2);
      }
    }
  }

  /// Clamped columns along which |A m + b| falls, the strongest first.
  std::vector<int> pulling_columns() {
    VectorXd pull = problem_.pulls(state_.point);
    std::vector<int> columns;
    for (int j = 0; j < pull.size(); ++j) {
      if (!problem_.bounded(j)) pull[j] = std::abs(pull[j]);
      if (column(j) == ColumnState::Clamped && pull[j] > 0) columns.push_back(j);
    }
    std::stable_sort(columns.begin(), columns.end(),
                     [&](int i, int j) { return pull[i] > pull[j]; });
    return columns;
  }

  bool gain_by(const std::vector<int>& columns) {
    const State before = state_;
    for (const int j : columns) column(j) = ColumnState::InPlay;
    fit_within_bounds();
    if (state_.point.square < before.point.square - before.point.rounding) return true;
    state_ = before;
    return false;
  }

  /// Where there are many answers, the search may take long to their edge: from amid them it is at
  /// its end.
  void start_amid() {
    const InteriorPoint amid = interior_point(problem_, state_.point.m, factorize_);
    factorizations_ += amid.factorizations;
    patience_ = factorizations_ + kIdleSteps;
    const State before = state_;
    VectorXd m = amid.m;
    for (Index j = 0; j < m.size(); ++j) {
      const bool in_play = !problem_.bounded(j) || m[j] > amid.slope[j];
      column(j) = in_play ? ColumnState::InPlay : ColumnState::Clamped;
      if (!in_play) m[j] = 0;
    }
    state_.point = problem_.at(std::move(m));
    if (problem_.conditions_hold(state_.point)) return;
    fit_within_bounds();
    if (!(state_.point.square <= before.point.square)) state_ = before;
  }

  void fit_within_bounds() {
    while (!fit() && factorizations_ < patience_) continue;
  }

  /// To the least over the columns in play; false where columns had to be clamped on the way.
  bool fit() {
    std::vector<int> in_play;
    for (int j = 0; j < problem_.A().cols(); ++j) {
      if (column(j) != ColumnState::Clamped) in_play.push_back(j);
    }
    if (in_play.empty()) return true;
    const auto factors = factor_(in_play);
    if (factorizations_++ == 0) condition_ = factors->condition();
    for (std::size_t k = 0; k < in_play.size(); ++k) {
      column(in_play[k]) = factors->dependent()[k] ? ColumnState::Dependent : ColumnState::InPlay;
    }
    const VectorXd least = least_over(in_play, *factors);
    return !least.allFinite() || move_to(problem_.at(least));
  }

  /// From where the search stands: where columns depend on each other, the nearest answer is the
  /// least likely to be beyond bounds.
  VectorXd least_over(const std::vector<int>& columns, const ColumnFactors& factors) const {
    VectorXd m = state_.point.m;
    // The second round removes what rounding left by the first.
    for (int round = 0; round < 2; ++round) {
      const VectorXd change = factors.solve(-(problem_.A() * m + problem_.b()));
      for (std::size_t k = 0; k < columns.size(); ++k) m[columns[k]] += change[k];
    }
    return m;
  }

  bool move_to(const BoundedPoint& least) {
    BoundedPoint allowed = problem_.at(problem_.clamped(least.m));
    if (problem_.same_residual(allowed, least)) {
      state_.point = std::move(allowed);
      return true;
    }
    state_.point = problem_.step(state_.point, least.m);
    for (Index j = 0; j < least.m.size(); ++j) {
      const bool met = problem_.bounded(j) && least.m[j] < 0 && state_.point.m[j] == 0;
      if (met) column(j) = ColumnState::Clamped;
    }
    return false;
  }

  const BoundedProblem& problem_;
  Factorize factorize_;
  FactorColumns factor_;
  State state_;
  double condition_ = 1;
  int factorizations_ = 0, patience_ = kIdleSteps;
};

}  // namespace

LeastSquaresResult bounded_search(const BoundedProblem& problem, Factorize factorize) {
  Search search(problem, factorize);
  search.run();
  return search.result();
}

}  // namespace camlaw::optim
