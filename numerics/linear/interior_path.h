// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "numerics/linear/interior_residuals.h"
#include "numerics/linear/newton_system.h"
#include "numerics/linear/quadratic_program.h"

/// The point of an interior-point method on its way (docs/optimisation.md, (XM3), (XM5), (XM8)).
namespace camlaw::optim::interior {

/// Point, slacks and multipliers on the way.
class InteriorPath {
 public:
  struct Step {
    VectorXd y, s, z;
    VectorXd w = {};  ///< multipliers of the equations

    bool is_finite() const { return y.allFinite() && z.allFinite() && w.allFinite(); }
  };

  InteriorPath(const ProgramSides& sides, VectorXd start, const InteriorOptions& options)
      : sides_(sides), start_(std::move(start)), near_(options.near), stage_(options.stage) {
    if ((options.begins_augmented || squares_too_much()) && make_augmented()) {
      take_augmented();
    } else {
      system_ = normal_equations(sides);
    }
    const auto most = [](const VectorXd& sums) { return sums.size() > 0 ? sums.maxCoeff() : 0; };
    const VectorXd ones = VectorXd::Ones(sides.variables());
    row_size_ = std::max(most(sides.side_terms(ones)), most(sides.equation_terms(ones)));
    column_size_ = most(
        sides.column_terms(VectorXd::Ones(sides.count()), VectorXd::Zero(sides.values.size())));
    equation_size_ = most(
        sides.column_terms(VectorXd::Zero(sides.count()), VectorXd::Ones(sides.values.size())));
    begin();
  }

  /// Puts the point where steps begin.
  void begin() {
    now_.y = start_;
    const VectorXd room = sides_.level - sides_.times(now_.y);
    if (sides_.is_linear() && near_ != nullptr) {
      begin_near(room);
    } else if (sides_.is_linear()) {
      // Slacks of order one, as rows are scaled to be, and small multipliers, which were seen to
      // take fewer iterations than those of order one. Mehrotra's own start takes a tenth fewer
      // where it works, and was seen to stall.
      constexpr double kSlack = 1, kMultiplier = 1e-3;
      now_.s = room.cwiseMax(kSlack);
      now_.z = VectorXd::Constant(sides_.count(), kMultiplier);
    } else {
      // Each row's own room, and multipliers that are centred: rows of a thousandth of the others'
      // room are held by a thousand times their multipliers.
      now_.s = room.cwiseMax(least_slack(room));
      now_.z = now_.s.cwiseInverse();
    }
    now_.w = VectorXd::Zero(sides_.values.size());
    if (stage_ != nullptr) begin_at(*stage_);
    look();
  }
  /// Of a solution of another program: slacks and multipliers that are no smaller, all of one
  /// product, so that the point is in the middle (docs/optimisation.md, (XM8)).
  void begin_near(const VectorXd& room) {
    constexpr double kProduct = 1e-5;
    const double middle = std::sqrt(kProduct);
    now_.s.resize(room.size()), now_.z.resize(room.size());
    for (Eigen::Index i = 0; i < room.size(); ++i) {
      const Eigen::Index row = sides_.row(i), bound = row - sides_.rows.rows();
      const double multiplier =
          bound < 0 ? sides_.sign(i) *
                          near_->row_multipliers[sides_.program_rows[static_cast<std::size_t>(row)]]
          : sides_.sign(i) > 0 ? near_->upper_multipliers[bound]
                               : near_->lower_multipliers[bound];
      if (multiplier > middle) {
        now_.z[i] = multiplier;
        now_.s[i] = std::max(room[i], kProduct / multiplier);
      } else {
        now_.s[i] = std::max(room[i], middle);
        now_.z[i] = kProduct / now_.s[i];
      }
    }
  }
  /// The same with the augmented system, where steps ended for want of it. Whether they did.
  bool begins_again() {
    if (augmented_ == nullptr) return false;
    take_augmented();
    near_ = nullptr;
    begin();
    return true;
  }

  /// What is left of the conditions where the point is now.
  void look() {
    dual_ =
        sides_.slope(now_.y) + sides_.transposed(now_.z) + sides_.equations.transpose() * now_.w;
    primal_ = sides_.times(now_.y) + now_.s - sides_.level;
    equation_ = sides_.equations * now_.y - sides_.values;
    take_terms();
  }

  const Step& now() const { return now_; }
  bool is_augmented() const { return is_augmented_; }
  InteriorStage stage() const {
    InteriorStage stage{gap(), now_.y, VectorXd::Zero(sides_.bounds()), {}};
    stage.multipliers = stage.slacks;
    for (Eigen::Index i = 0; i < sides_.count(); ++i) {
      stage.slacks[sides_.bound(i)] = now_.s[i];
      stage.multipliers[sides_.bound(i)] = now_.z[i];
    }
    return stage;
  }
  double objective() const { return sides_.objective(now_.y); }
  double gap() const { return now_.s.dot(now_.z); }
  /// The largest residual of a row; of a column (relative()).
  double primal() const {
    return std::max(relative(primal_, side_terms_), relative(equation_, equation_terms_));
  }
  double dual() const { return relative(dual_, column_terms_); }
  /// Whether residuals are as small as they are to be: without the augmented system as they stand.
  /// Where they were reckoned from steps, they are looked at, and if rounding has left more, from
  /// then on after each step.
  bool is_balanced() {
    if (!are_small()) return false;
    if (!is_reckoned_) return true;
    look();
    is_reckoned_ = are_small();
    return is_reckoned_;
  }

  bool step() {
    weights_ = now_.z.cwiseQuotient(now_.s);
    if (!system_->factor(sides_.weights_by_row(weights_))) {
      needs_other_begin();
      return false;
    }
    const VectorXd products = now_.s.cwiseProduct(now_.z);
    const Step foresight = solve_once({dual_, primal_, equation_, products});
    const double mean = gap() / static_cast<double>(now_.s.size());
    const double ahead = (now_.s + reach(now_.s, foresight.s) * foresight.s)
                             .dot(now_.z + reach(now_.z, foresight.z) * foresight.z) /
                         static_cast<double>(now_.s.size());
    const double centring = std::pow(std::max(ahead, 0.0) / mean, 3);
    const VectorXd aimed = products + foresight.s.cwiseProduct(foresight.z) -
                           VectorXd::Constant(now_.s.size(), centring * mean);
    VectorXd lost;
    Step step = solve({dual_, primal_, equation_, aimed}, lost);
    if (!sides_.is_linear()) {
      centre(step, centring * mean);
      lost = dual_ + change_of_dual(step);
    }
    if (!was_augmented_tried_ && is_lost(step, lost) && needs_other_begin()) return false;
    return step.is_finite() && go(step, lost);
  }

  /// One step for the columns alone, which balances them to rounding: a lower bound that the
  /// multipliers tell goes by what is left of these. Each changes in proportion to what it is over
  /// its slack.
  void balance_columns() {
    weights_ = now_.z.cwiseQuotient(now_.s);
    if (!system_->factor(sides_.weights_by_row(weights_))) return;
    const double before = largest_dual(), gap_before = gap(), primal_before = primal();
    const Step last = now_;
    const NewtonStep step = system_->solve(-dual_, {}, VectorXd::Zero(sides_.values.size()));
    const VectorXd change = of_sides(step.changes);
    now_.y += step.y;
    now_.w += step.w;
    now_.s -= change;
    now_.z = (now_.z + weights_.cwiseProduct(change)).cwiseMax(0);
    look();
    // A step that balances the columns may double what is left of gap and rows, which are far
    // within their tolerances by then; what is rounding already may grow to kRounding.
    constexpr double kMore = 2, kRounding = 1e-12;
    const bool holds = now_.s.minCoeff() > 0 && gap() <= kMore * gap_before &&
                       primal() <= kMore * primal_before + kRounding;
    if (holds && largest_dual() < before) return;
    now_ = last;
    look();
  }

 private:
  /// Whether the columns of a quadratic program are so long that normal equations, which square
  /// them, were seen to lose too many digits before its end.
  bool squares_too_much() const {
    constexpr double kMost = 1e10;
    if (sides_.is_linear()) return false;
    const VectorXd ones = VectorXd::Ones(sides_.rows.rows());
    const VectorXd squares = sides_.rows.cwiseAbs2().transpose() * ones;
    return squares.size() > 0 && squares.maxCoeff() > kMost;
  }

  /// What the stage has; other bounds are centred as it is.
  void begin_at(const InteriorStage& stage) {
    const double mean = stage.gap / static_cast<double>(sides_.count());
    now_.y = stage.y;
    const VectorXd room = sides_.level - sides_.times(now_.y);
    const double least = least_slack(room);
    for (Eigen::Index i = 0; i < sides_.count(); ++i) {
      const double slack = stage.slacks[sides_.bound(i)];
      now_.s[i] = slack > 0 ? slack : std::max(room[i], least);
      now_.z[i] = slack > 0 ? stage.multipliers[sides_.bound(i)] : mean / now_.s[i];
    }
  }

  /// Further corrections of a step that is short because some products of slacks and multipliers
  /// run ahead of the others, or stay behind (Gondzio 1996).
  void centre(Step& step, double mu) const {
    constexpr double kFarther = 0.3, kGain = 0.1 * kFarther, kLong = 0.9, kLow = 0.1, kHigh = 10;
    constexpr int kMost = 2;
    double now = std::min(reach(now_.s, step.s), reach(now_.z, step.z));
    for (int times = 0; times < kMost && now < kLong; ++times) {
      const double aim = std::min(1.0, now + kFarther);
      const VectorXd ahead = (now_.s + aim * step.s).cwiseProduct(now_.z + aim * step.z);
      const VectorXd away =
          (ahead - ahead.cwiseMax(kLow * mu).cwiseMin(kHigh * mu)).cwiseMin(kHigh * mu);
      const Step more = solve_once({VectorXd::Zero(dual_.size()), VectorXd::Zero(primal_.size()),
                                    VectorXd::Zero(equation_.size()), away});
      Step longer{step.y + more.y, step.s + more.s, step.z + more.z, step.w + more.w};
      const double then = std::min(reach(now_.s, longer.s), reach(now_.z, longer.z));
      if (!(then >= now + kGain)) return;
      step = std::move(longer);
      now = then;
    }
  }

  /// Of a start: a share of what rows, as they are scaled, have room for on average; 1 where none
  /// has room.
  double least_slack(const VectorXd& room) const {
    // Slacks of a tenth of the room begin inside and near what the rows say; no step starts nearer
    // to a row than kLeast.
    constexpr double kShare = 0.1, kMost = 1, kLeast = 1e-6, kNone = 1e-9;
    double sum = 0;
    int count = 0;
    for (Eigen::Index i = 0; i < room.size(); ++i) {
      if (sides_.row(i) >= sides_.rows.rows()) continue;
      sum += std::min(kMost, std::abs(room[i]));
      ++count;
    }
    return sum <= kNone ? kMost : std::max(kLeast, kShare * sum / count);
  }

  bool are_small() const {
    if (is_augmented_) return std::max(primal(), dual()) <= kLeft;
    return largest(primal_) <= kLeft && largest(equation_) <= kLeft && largest(dual_) <= kLeft;
  }

  /// What is left of the conditions, and the products of slacks and multipliers to take away.
  struct Left {
    const VectorXd &dual, &primal, &equation, &products;
  };

  double largest_dual() const { return dual_.cwiseAbs().maxCoeff(); }

  /// Sums of residuals' terms, where any may be large enough to count.
  void take_terms() {
    const double y = largest(now_.y), z = largest(now_.z), w = largest(now_.w);
    const bool none_counts =
        kTerms * row_size_ * y <= 1 && kTerms * (column_size_ * z + equation_size_ * w) <= 1;
    if (none_counts) {
      side_terms_.resize(0), equation_terms_.resize(0), column_terms_.resize(0);
      return;
    }
    side_terms_ = sides_.side_terms(now_.y);
    equation_terms_ = sides_.equation_terms(now_.y);
    column_terms_ = sides_.column_terms(now_.z, now_.w);
  }

  /// `lost`: what a whole step leaves of the columns' residuals.
  bool go(const Step& step, const VectorXd& lost) {
    double primal_reach = short_of(reach(now_.s, step.s));
    double dual_reach = short_of(reach(now_.z, step.z));
    // The slope of a quadratic cost goes with the point, so that the multipliers must keep up.
    if (!sides_.is_linear()) primal_reach = dual_reach = std::min(primal_reach, dual_reach);
    now_.y += primal_reach * step.y;
    now_.s += primal_reach * step.s;
    now_.z += dual_reach * step.z;
    now_.w += dual_reach * step.w;
    if (is_reckoned_) {
      // Rows go with the point, and a whole step meets them.
      primal_ *= 1 - primal_reach;
      equation_ += primal_reach * (sides_.equations * step.y);
      dual_ += dual_reach * (lost - dual_);
    } else {
      look();
    }
    return std::max(primal_reach, dual_reach) > 1e-8;
  }

  /// G dy + ds = -primal, E dy = -equation, curvature dy + G^T dz + E^T dw = -dual, z ds + s dz =
  /// -products. `lost` gets what rounding leaves of the columns' residuals.
  Step solve(const Left& left, VectorXd& lost) const {
    // Once more for what rounding left: normal equations square the condition.
    Step step = solve_once(left);
    lost = left.dual + change_of_dual(step);
    const VectorXd equation = left.equation + sides_.equations * step.y;
    const Step more =
        is_augmented_ ? solve_again(left, step, lost, equation) : solve_columns(lost, equation);
    step.y += more.y;
    step.s += more.s;
    step.z += more.z;
    step.w += more.w;
    lost += change_of_dual(more);
    return step;
  }
  Step solve_again(const Left& left, const Step& step, const VectorXd& dual,
                   const VectorXd& equation) const {
    const VectorXd primal = left.primal + sides_.times(step.y) + step.s;
    const VectorXd products =
        left.products + now_.z.cwiseProduct(step.s) + now_.s.cwiseProduct(step.z);
    return solve_once({dual, primal, equation, products});
  }
  VectorXd change_of_dual(const Step& step) const {
    VectorXd change = sides_.transposed(step.z);
    if (step.w.size() > 0) change += sides_.equations.transpose() * step.w;
    if (!sides_.is_linear()) change += sides_.curvature.selfadjointView<Eigen::Lower>() * step.y;
    return change;
  }
  Step solve_once(const Left& left) const {
    const VectorXd pull = weights_.cwiseProduct(left.primal) - left.products.cwiseQuotient(now_.s);
    const NewtonStep solved = system_->solve(-left.dual, sides_.by_row(pull), -left.equation);
    Step step{solved.y, -left.primal - of_sides(solved.changes), {}, solved.w};
    step.z = -left.products.cwiseQuotient(now_.s) - weights_.cwiseProduct(step.s);
    return step;
  }
  /// The same where rows are met and products are as they are to be.
  Step solve_columns(const VectorXd& dual, const VectorXd& equation) const {
    const NewtonStep solved = system_->solve(-dual, {}, -equation);
    Step step{solved.y, -of_sides(solved.changes), {}, solved.w};
    step.z = -weights_.cwiseProduct(step.s);
    return step;
  }
  VectorXd of_sides(const VectorXd& changes) const {
    VectorXd result(sides_.count());
    for (Eigen::Index i = 0; i < result.size(); ++i)
      result[i] = sides_.sign(i) * changes[sides_.row(i)];
    return result;
  }

  /// Whether rounding has left of the residuals of columns or equations more than a step is to take
  /// away.
  bool is_lost(const Step& step, const VectorXd& lost) {
    // A step with three digits still gains; with fewer the residuals stay.
    constexpr double kMuch = 1e-3;
    const auto is_little = [](const VectorXd& left, const VectorXd& before) {
      return largest(left) <= std::max(kMuch * largest(before), kLeft / 2);
    };
    const VectorXd equation = equation_ + sides_.equations * step.y;
    if (is_little(lost, dual_) && is_little(equation, equation_)) return false;
    take_terms();
    const double columns = relative(lost, column_terms_);
    const double equations = relative(equation, equation_terms_);
    return !(columns <= std::max(kMuch * dual(), kLeft / 2)) ||
           !(equations <= std::max(kMuch * relative(equation_, equation_terms_), kLeft / 2));
  }
  /// Whether steps that rounding spoils are to end: from near another answer, where the middle may
  /// do better, or where the augmented system does.
  bool needs_other_begin() { return near_ != nullptr || make_augmented(); }
  /// Makes the augmented system, once, to begin again with: points that such steps have led to are
  /// off the middle. False where there is none, or it was made before.
  bool make_augmented() {
    if (std::exchange(was_augmented_tried_, true)) return false;
    augmented_ = augmented_system(sides_);
    return augmented_ != nullptr;
  }

  void take_augmented() {
    system_ = std::move(augmented_);
    is_augmented_ = true;
    is_reckoned_ = false;
  }

  const ProgramSides& sides_;
  VectorXd start_;
  const InteriorSolution* near_;
  const InteriorStage* stage_;
  std::unique_ptr<NewtonSystem> system_, augmented_;
  bool was_augmented_tried_ = false, is_augmented_ = false;
  bool is_reckoned_ = true;  ///< whether residuals are reckoned from steps
  Step now_;
  VectorXd weights_;                                     ///< of sides: z over s
  VectorXd dual_, primal_, equation_;                    ///< residuals
  VectorXd side_terms_, equation_terms_, column_terms_;  ///< empty where none counts
  /// The largest sums of the magnitudes of a row's entries, a column's, and a column's in
  /// equations.
  double row_size_ = 0, column_size_ = 0, equation_size_ = 0;
};

}  // namespace camlaw::optim::interior
