// SPDX-License-Identifier: MIT
#include "fitting/motions/record_faults.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/law_fit_samples.h"
#include "fitting/motions/motion_residuals.h"
#include "fitting/motions/rounding_errors.h"
#include "numerics/linear/dense.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// What a law leaves of one motion's samples, before and after the law's own numbers have followed
/// a fault, each row by the root of its weight.
struct Left {
  VectorXd residual;  ///< without its part in the span of the law's own columns
  MatrixXd fault;     ///< the fault's columns without theirs
  double rest = 0;    ///< squares that no curve follows
};

/// Columns of the Jacobian that the fit moved.
std::vector<Eigen::Index> free_columns(const optim::FitResult& fit) {
  std::vector<Eigen::Index> result;
  for (std::size_t j = 0; j < fit.parameters.size(); ++j) {
    const optim::FittedParameter& p = fit.parameters[j];
    if (!p.at_bound && p.standard_deviation != 0) result.push_back(static_cast<Eigen::Index>(j));
  }
  return result;
}

/// A law's residuals, its Jacobian's free columns and a fault's at the samples, each row by the
/// root of its weight where they are weighted.
struct Columns {
  std::vector<Eigen::Index> free;  ///< which of the parameters
  MatrixXd own, fault;
  VectorXd residual;
  double rest;
};

/// What stands for the samples of a fit and a fault: samples where either breaks stay as they are.
StandIns stand_ins_of(const LawFit& fit, const LawFitSamples& samples, const PossibleFault& fault) {
  if (fit.fit.loss_scale) return samples.all();  // each has its own weight
  std::vector<double> breaks = breaks_of(fit.law.law(), fit.begin, fit.end);
  const auto& places = samples.all().place;
  if (fault.jump_period > 0 && !places.empty()) {
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    for (double k = std::ceil((*low - fault.jump) / fault.jump_period);
         fault.jump + k * fault.jump_period <= *high; ++k) {
      breaks.push_back(fault.jump + k * fault.jump_period);
    }
    std::sort(breaks.begin(), breaks.end());
  }
  return samples.standing_for(breaks);
}

std::optional<Columns> columns_of(const LawFit& fit, const LawFitSamples& samples,
                                  const PossibleFault& fault, bool weighted) {
  const StandIns few = stand_ins_of(fit, samples, fault);
  const std::size_t n = few.samples.place.size(), p = fit.fit.parameters.size();
  std::vector<double> r(n), rows(n * p);
  if (!MotionResiduals(few, fit.law, fit.skew).evaluate(values_of(fit.fit), r, rows)) return {};
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto count = static_cast<Eigen::Index>(n);
  const Eigen::Map<const RowMajor> jacobian(rows.data(), count, static_cast<Eigen::Index>(p));
  Columns columns{free_columns(fit.fit), {}, MatrixXd(count, fault.by.size()), {}, few.rest};
  columns.residual = Eigen::Map<const VectorXd>(r.data(), count);
  columns.own.resize(count, static_cast<Eigen::Index>(columns.free.size()));
  for (std::size_t j = 0; j < columns.free.size(); ++j) {
    columns.own.col(static_cast<Eigen::Index>(j)) = jacobian.col(columns.free[j]);
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    for (std::size_t j = 0; j < fault.by.size(); ++j) {
      columns.fault(i, static_cast<Eigen::Index>(j)) =
          fault.by[j](few.samples.place[k]) * (few.roots.empty() ? 1 : few.roots[k]);
    }
    if (!weighted || !few.roots.empty()) continue;
    const double root = std::sqrt(fit.fit.weights[k]);
    columns.own.row(i) *= root, columns.fault.row(i) *= root, columns.residual[i] *= root;
  }
  if (!columns.own.allFinite() || !columns.fault.allFinite()) return {};
  return columns;
}

std::optional<Left> left_by(const LawFit& fit, const LawFitSamples& samples,
                            const PossibleFault& fault, bool weighted) {
  auto columns = columns_of(fit, samples, fault, weighted);
  if (!columns) return {};
  Left left{std::move(columns->residual), std::move(columns->fault), columns->rest};
  if (columns->own.cols() == 0) return left;
  columns->own.colwise().normalize();  // so that the rank does not depend on units
  const MatrixXd basis = optim::column_space(columns->own);
  left.residual -= basis * (basis.transpose() * left.residual);
  left.fault -= basis * (basis.transpose() * left.fault);
  return left;
}

/// What the laws of one motion leave.
struct Motion {
  std::vector<Left> left;
  std::vector<std::size_t> numbers;  ///< of each law
  std::size_t count = 0;             ///< of its samples
  double least = 0;                  ///< sum of squares that is told from 0
};

Motion motion_of(const std::vector<LawFit>& ranking, const MotionSamples& samples,
                 const PossibleFault& fault, bool weighted) {
  Motion motion{{}, {}, samples.place.size(), least_sum_of_squares(samples)};
  if (ranking.empty()) return motion;
  const LawFitSamples of(samples, ranking.front().motion(), optim::Loss::None);
  for (const LawFit& fit : ranking) {
    auto left = left_by(fit, of, fault, weighted);
    if (!left) continue;
    motion.left.push_back(std::move(*left));
    motion.numbers.push_back(fit.numbers);
  }
  return motion;
}

/// A law of a motion that is best by some count.
struct Best {
  double score = std::numeric_limits<double>::infinity();
  std::size_t law = 0;
  double squares = 0;
};

/// `size_of`: of the fault, by what a law leaves; `more`: numbers that it counts as.
template <class SizeOf>
Best best_of(const Motion& motion, const FaultScore& score, std::size_t more,
             const SizeOf& size_of) {
  Best best;
  for (std::size_t l = 0; l < motion.left.size(); ++l) {
    const Left& left = motion.left[l];
    const VectorXd rest = left.residual - left.fault * size_of(left);
    const double squares = std::max(rest.squaredNorm() + left.rest, motion.least);
    const double own = score.of(motion.count, motion.numbers[l] + more, squares);
    if (own < best.score) best = {own, l, squares};
  }
  return best;
}

/// One size of a fault for all motions, by the laws that are best with it.
struct Combined {
  MatrixXd information;
  VectorXd pulled;

  explicit Combined(Eigen::Index unknowns)
      : information(MatrixXd::Zero(unknowns, unknowns)), pulled(VectorXd::Zero(unknowns)) {}
  void add(const Motion& motion, const Best& best, std::size_t more) {
    const auto taken = static_cast<double>(motion.numbers[best.law] + more);
    const double variance = best.squares / std::max(static_cast<double>(motion.count) - taken, 1.0);
    const Left& left = motion.left[best.law];
    if (!(variance > 0)) return;
    information += left.fault.transpose() * left.fault / variance;
    pulled += left.fault.transpose() * left.residual / variance;
  }
  VectorXd size() const { return optim::shortest_least_squares(information, pulled).x; }
  MatrixXd covariance() const {
    const auto [inverse, rank] = optim::pseudo_inverse(information);
    if (rank == information.rows()) return inverse;
    return MatrixXd::Constant(information.rows(), information.rows(),
                              std::numeric_limits<double>::infinity());
  }
};

}  // namespace

PossibleFault drift(double first, double range, double period) {
  return {FaultKind::Drift,
          {"drift"},
          {[=](double place) {
            const double at = period > 0 ? in_period(place, first, period) : place;
            return (at - first) / range;
          }},
          first,
          period};
}

PossibleFault off_centre() {
  return {FaultKind::OffCentre,
          {"centre_x", "centre_y"},
          {[](double place) { return std::cos(place * kDegree); },
           [](double place) { return std::sin(place * kDegree); }}};
}

void widen(LawFit& fit, const MotionSamples& samples, const PossibleFault& fault,
           const MatrixXd& covariance) {
  const LawFitSamples of(samples, fit.motion(), optim::Loss::None);
  const auto columns = columns_of(fit, of, fault, true);
  if (!columns || columns->own.cols() == 0) return;
  const MatrixXd follow = optim::least_squares(columns->own, columns->fault);
  const MatrixXd more = follow * covariance * follow.transpose();
  for (std::size_t k = 0; k < columns->free.size(); ++k) {
    optim::FittedParameter& p = fit.fit.parameters[static_cast<std::size_t>(columns->free[k])];
    const auto i = static_cast<Eigen::Index>(k);
    if (!(p.standard_deviation > 0) || !std::isfinite(p.standard_deviation)) continue;
    const double wider = std::sqrt(1 + more(i, i) / (p.standard_deviation * p.standard_deviation));
    p.standard_deviation *= wider;
    p.low = p.value - wider * (p.value - p.low);
    p.high = p.value + wider * (p.high - p.value);
  }
}

FaultScore by_aicc() { return {optim::aicc, true}; }

FaultTest test_fault(const std::vector<std::vector<LawFit>>& rankings,
                     const std::vector<MotionSamples>& samples, PossibleFault fault,
                     const FaultScore& score) {
  const std::size_t more = fault.by.size();
  const auto unknowns = static_cast<Eigen::Index>(more);
  std::vector<Motion> motions;
  double without = 0;
  Combined apart(unknowns);  // where each motion has its own size
  for (std::size_t k = 0; k < rankings.size(); ++k) {
    Motion motion = motion_of(rankings[k], samples[k], fault, score.weighted);
    const Best plain =
        best_of(motion, score, 0, [&](const Left&) { return VectorXd::Zero(unknowns); });
    const Best own = best_of(motion, score, more, [](const Left& left) {
      return optim::least_squares(left.fault, left.residual);
    });
    if (!std::isfinite(plain.score) || !std::isfinite(own.score)) continue;
    without += plain.score;
    apart.add(motion, own, more);
    motions.push_back(std::move(motion));
  }
  // One size for all, which may make other laws the best.
  VectorXd size = apart.size();
  Combined together(unknowns);
  for (const Motion& motion : motions) {
    together.add(motion, best_of(motion, score, more, [&](const Left&) { return size; }), more);
  }
  size = together.size();
  FaultTest test{std::move(fault), 0, 0, -size, together.covariance()};
  for (std::size_t k = 0; k < motions.size(); ++k) {  // the fault's own numbers count once
    test.score +=
        best_of(motions[k], score, k == 0 ? more : 0, [&](const Left&) { return size; }).score;
  }
  test.gain = motions.empty() ? 0 : without - test.score;
  return test;
}

std::vector<FaultTest> seen_faults(std::vector<FaultTest> tests) {
  constexpr double kAsWell = 4;  // exp(-4 / 2): a seventh of the likelihood
  std::erase_if(tests, [](const FaultTest& test) {
    return !(test.gain > (test.with_plain_laws ? kGainWithPlainLaws : kGainOfFault));
  });
  std::stable_sort(tests.begin(), tests.end(),
                   [](const FaultTest& a, const FaultTest& b) { return a.gain > b.gain; });
  std::erase_if(tests, [best = tests.empty() ? 0 : tests.front().gain](const FaultTest& test) {
    return test.gain < best - kAsWell;
  });
  return tests;
}

}  // namespace camlaw::problems
