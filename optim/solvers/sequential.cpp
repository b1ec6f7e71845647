// SPDX-License-Identifier: MIT
#include "optim/solvers/sequential.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "optim/solvers/quadratic_step.h"
#include "optim/solvers/read_off.h"
#include "optim/solvers/run_end.h"

namespace camlaw::optim {
namespace {

using Eigen::VectorXd;

std::span<const double> entries_of(const VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// Pairs of violation and objective that later places have to be better than in one or the other
/// (Fletcher and Leyffer 2002).
class Filter {
 public:
  bool accepts(double violation, double objective) const {
    return std::all_of(pairs_.begin(), pairs_.end(), [&](const auto& pair) {
      return is_better(violation, objective, pair.first, pair.second);
    });
  }
  static bool is_better(double violation, double objective, double than_violation,
                        double than_objective) {
    constexpr double kMargin = 1e-5;  // of filter methods (Waechter and Biegler 2006)
    return violation <= (1 - kMargin) * than_violation ||
           objective <= than_objective - kMargin * violation;
  }
  void add(double violation, double objective) { pairs_.emplace_back(violation, objective); }

 private:
  std::vector<std::pair<double, double>> pairs_;
};

/// Steps of a program from one place on.
class Sequence {
 public:
  Sequence(const Program& program, const SolverOptions& options, VectorXd y)
      : program_(program), options_(options), place_(point_at(program, std::move(y))) {
    multipliers_.rows = VectorXd::Zero(static_cast<Eigen::Index>(program.rows()));
    multipliers_.lower = multipliers_.upper = VectorXd::Zero(place_.y.size());
    interior_.least_objective = 1;  // programs are scaled, and a last step is worth nothing
    interior_.goes_on = [this](int, double, double) { return !ended(); };
  }

  void begin_with(const std::vector<double>& rows) {
    if (rows.size() == program_.rows())
      multipliers_.rows = Eigen::Map<const VectorXd>(rows.data(), multipliers_.rows.size());
    reach_ = kWarmReach;
  }

  Solution run() {
    constexpr int kMost = 100;  // Ipopt goes on where so many steps have not led to the end
    if (!place_.is_finite()) return answer(Status::NonFiniteStart, "not a number at the start");
    while (iterations_ < options_.max_iterations) {
      if (iterations_ >= kMost) return answer(Status::Stalled, "the steps do not converge");
      if (options_.progress) {
        options_.progress(
            {iterations_, program_.unscaled_objective(place_.objective), place_.violation});
      }
      const Advance advance = advanced();
      if (advance == Advance::Undefined && iterations_ == 0)
        return answer(Status::NonFiniteStart, "a slope is not a number at the start");
      ++iterations_;
      if (stopped_) return answer(stopped_->status, stopped_->message);
      if (advance == Advance::None || advance == Advance::Undefined)
        return answer(Status::Stalled, "no step leads to a better point");
      if (place_.violation <= kMet && is_far_out(program_, entries_of(place_.y)))
        return answer(Status::Unbounded, "the objective decreases without bound");
      if (advance == Advance::Last) {
        if (place_.violation > kMet) return answer(Status::Infeasible, "no step meets the limits");
        return answer(Status::Solved, "no step improves the design");
      }
    }
    return answer(Status::IterationLimit, "limit of iterations");
  }

 private:
  enum class Advance { Some, Last, None, Undefined };
  static constexpr double kLastStep = 1e-6;   // of a variable: Newton's next would be rounding
  static constexpr double kRounding = 1e-11;  // of an objective: what it changes by says nothing

  /// The place after a step, on whose way no variable passes a bound by rounding.
  ProgramPoint moved(const VectorXd& d) {
    ++evaluations_;
    VectorXd y = place_.y + d;
    for (std::size_t i = 0; i < program_.variables(); ++i) {
      double& at = y[static_cast<Eigen::Index>(i)];
      at = std::clamp(at, program_.lower()[i], program_.upper()[i]);
    }
    return point_at(program_, std::move(y));
  }
  double rounding() const { return kRounding * (1 + std::abs(place_.objective)); }
  /// Of a place; what is met is met.
  double passed(const ProgramPoint& place) const {
    return place.violation <= kMet ? 0 : place.violation;
  }

  /// One step that is worth taking, from models of the place where it stands.
  Advance advanced() {
    constexpr double kLeastRadius = 1e-10;  // shorter steps change rows and objective by rounding
    const LocalModel model = model_at(program_, place_, multipliers_.rows);
    if (!model.is_finite()) return Advance::Undefined;
    Quadratics quadratics(program_, model, reach_, memory_);
    unsolved_radius_ = kInfinity;
    while (radius_ > kLeastRadius) {
      const auto advance =
          goal_ == StepGoal::Rows ? restored(model, quadratics) : improved(model, quadratics);
      if (ended()) return Advance::None;
      if (advance) return *advance;
    }
    return Advance::None;
  }

  void cut_region(double length) {
    memory_.stages.clear();  // of a program that was wrong by more than it promised
    radius_ = kShrink * std::min(radius_, length);
    is_cut_ = true;
  }

  /// A step towards rows that are met; none where it is refused, or the rows can be met after all.
  std::optional<Advance> restored(const LocalModel& model, Quadratics& quadratics) {
    // A step has to keep a tenth of its promise. A promise of less than a thousandth of what counts
    // as met is rounding.
    constexpr double kGood = 0.1, kWorth = 1e-3;
    const auto step = quadratics.step(place_.y, place_.rows, radius_, StepGoal::Rows, interior_);
    if (!step) {
      cut_region(radius_);
      return {};
    }
    if (step->passed <= kMet) {
      // Where the method has not solved the objective's program in this region, a smaller one.
      if (radius_ >= unsolved_radius_) cut_region(radius_);
      goal_ = StepGoal::Objective;
      return {};
    }
    const double promised = place_.violation - step->passed;
    if (promised <= kWorth * kMet || promised <= kRounding * place_.violation)
      return step->length() < kAtEdge * radius_ ? Advance::Last : Advance::None;
    ProgramPoint trial = moved(step->d);
    if (!trial.is_finite() || place_.violation - trial.violation < kGood * promised) {
      cut_region(step->length());
      return {};
    }
    if (is_idle(trial.violation)) return Advance::Last;
    filter_.add(passed(place_), place_.objective);
    const double share = (place_.violation - trial.violation) / promised;
    grow_region(share, *step);
    go_to(std::move(trial), model, step->d);
    return Advance::Some;
  }

  /// Whether steps towards the rows have come to little for long.
  bool is_idle(double violation) {
    // A region that was cut to a hundredth takes twelve steps to grow back.
    constexpr int kPatience = 15;
    constexpr double kLess = 0.9;
    if (violation < kLess * least_passed_) {
      least_passed_ = violation;
      idle_ = 0;
    }
    return ++idle_ > kPatience;
  }

  /// A step to a better objective within the rows, or the same corrected for how rows bend.
  std::optional<Advance> improved(const LocalModel& model, Quadratics& quadratics) {
    const auto step =
        quadratics.step(place_.y, place_.rows, radius_, StepGoal::Objective, interior_);
    if (!step) {
      if (ended()) return Advance::None;
      unsolved_radius_ = radius_;
      goal_ = StepGoal::Rows;
      return {};
    }
    // One program may fail where rows are badly scaled; after five the next would too.
    constexpr int kMostInexact = 4;
    inexact_ = step->is_exact ? 0 : inexact_ + 1;
    if (inexact_ > kMostInexact) return Advance::None;
    const double promised = -model.change(step->d);
    // A step that a small region cut short says nothing.
    constexpr double kSmall = 1e-3;
    const bool is_inside = step->length() < kAtEdge * radius_;
    const bool is_short = step->length() <= kLastStep && is_inside;
    const bool is_worthless = std::abs(promised) <= rounding() && (is_inside || radius_ >= kSmall);
    ProgramPoint trial = moved(step->d);
    if (is_short || (passed(place_) == 0 && is_worthless)) {
      const bool holds = trial.is_finite() && trial.violation <= std::max(place_.violation, kMet);
      multipliers_ = step->multipliers;
      if (holds) {
        place_ = std::move(trial);
        memory_.moved(step->d);
      }
      if (passed(place_) > 0) return Advance::None;
      return holds && needs_balance() ? Advance::Some : Advance::Last;
    }
    if (is_good(trial, promised)) return taken(std::move(trial), model, *step, promised);
    if (trial.is_finite()) {
      const VectorXd bent = trial.rows - model.jacobian * step->d;
      const auto second = quadratics.step(place_.y, bent, radius_, StepGoal::Objective, interior_);
      if (second) {
        ProgramPoint corrected = moved(second->d);
        if (is_good(corrected, promised))
          return taken(std::move(corrected), model, *second, promised);
      }
    }
    cut_region(step->length());
    return {};
  }

  /// Whether the multipliers of a last step leave more of the slopes there than they would after
  /// another one: the model whose program gave them is not quite that of the place.
  bool needs_balance() {
    constexpr int kMost = 4;  // each is Newton's: what four leave is the multipliers' rounding
    // The first is a hundredth of what certifies a design, the second some twenty units of the last
    // place of the terms of a sum.
    constexpr double kBalanced = 1e-9, kOfTerms = 4e-15;
    if (++balances_ > kMost) return false;
    VectorXd left(place_.y.size());
    program_.gradient(entries_of(place_.y), {left.data(), program_.variables()});
    const auto jacobian = jacobian_matrix(program_, entries_of(place_.y));
    left += jacobian.transpose() * multipliers_.rows + multipliers_.upper - multipliers_.lower;
    const VectorXd terms = jacobian.cwiseAbs().transpose() * multipliers_.rows.cwiseAbs();
    const double rounding = kOfTerms * terms.lpNorm<Eigen::Infinity>();
    if (!(left.lpNorm<Eigen::Infinity>() > std::max(kBalanced, rounding))) return false;
    settled_ = {place_, multipliers_};
    return true;
  }

  /// Whether the objective falls by a good part of what the model says, if it says that it falls by
  /// more than the rows are worth; else whether the filter takes the place.
  bool is_good(const ProgramPoint& trial, double promised) const {
    // A step has to keep a tenth of its promise, and may leave the rows by ten scales on its way.
    constexpr double kGood = 0.1, kMost = 10;
    if (!trial.is_finite()) return false;
    const double violation = passed(trial), before = passed(place_);
    if (violation > std::max(kMost, 2 * passed_at_first_)) return false;
    if (!filter_.accepts(violation, trial.objective) ||
        !Filter::is_better(violation, trial.objective, before, place_.objective)) {
      return false;
    }
    return !is_about_objective(promised) || place_.objective - trial.objective >= kGood * promised;
  }
  bool is_about_objective(double promised) const {
    constexpr double kOfSquare = 1e-4;  // the switching condition of filter methods
    const double before = passed(place_);
    return promised > 0 && promised >= kOfSquare * before * before && promised > rounding();
  }

  Advance taken(ProgramPoint trial, const LocalModel& model, const ProgramStep& step,
                double promised) {
    const double gained = place_.objective - trial.objective;
    const bool at_edge = step.length() >= kAtEdge * radius_;
    // Where the model tells objective and rows to rounding the next step will be worth nothing.
    const VectorXd bends = trial.rows - place_.rows - model.jacobian * step.d;
    const double unforeseen =
        std::abs(promised - gained) + step.multipliers.rows.cwiseAbs().dot(bends.cwiseAbs());
    memory_.unforeseen = unforeseen;
    const bool last = unforeseen <= rounding() && !at_edge && passed(trial) == 0;
    if (is_about_objective(promised)) {
      grow_region(gained / promised, step);
    } else {
      filter_.add(passed(place_), place_.objective);
      grow_region(1, step);
    }
    multipliers_ = step.multipliers;
    go_to(std::move(trial), model, step.d);
    return last && !needs_balance() ? Advance::Last : Advance::Some;
  }

  /// After a step to its edge that kept its promise. A region that a step had to be cut to is near
  /// what the models are good for.
  void grow_region(double share, const ProgramStep& step) {
    constexpr double kMostRadius = 1e6;  // typical changes: the box of any sound problem is smaller
    struct Growth {
      double least_share, factor;
    };
    constexpr Growth kAtFirst{0.5, 4}, kLater{0.8, 1.5};
    const Growth& growth = is_cut_ ? kLater : kAtFirst;
    if (share >= growth.least_share && step.length() >= kAtEdge * radius_)
      radius_ = std::min(kMostRadius, growth.factor * radius_);
  }

  void go_to(ProgramPoint trial, const LocalModel& model, const VectorXd& d) {
    // The next step may be twice as long as the last before a row is missed.
    constexpr double kReach = 2;
    reach_ = kReach * (model.jacobian * d).lpNorm<Eigen::Infinity>();
    place_ = std::move(trial);
    memory_.moved(d);
  }

  bool ended() {
    if (is_stopped(options_)) stopped_ = RunEnd{Status::Stopped, "stopped"};
    if (is_late(options_, began_)) stopped_ = RunEnd{Status::TimeLimit, "time limit"};
    return stopped_.has_value();
  }

  Solution answer(Status status, std::string message) {
    if (settled_ && status != Status::Solved) {
      place_ = std::move(settled_->place);
      multipliers_ = std::move(settled_->multipliers);
      status = Status::Solved;
      message = "no step improves the design";
    }
    Solution solution{.status = status, .message = std::move(message)};
    const auto list = [](const VectorXd& v) { return std::vector<double>(v.begin(), v.end()); };
    solution.y = list(place_.y);
    solution.rows = list(multipliers_.rows);
    solution.lower = list(multipliers_.lower);
    solution.upper = list(multipliers_.upper);
    solution.iterations = iterations_;
    solution.evaluations = evaluations_;
    return solution;
  }

  /// A row passed by less, by its size, is met: far within the tolerance of any limit.
  static constexpr double kMet = 1e-9;
  static constexpr double kShrink = 0.5, kAtEdge = 0.9, kWarmReach = 1e-2;

  const Program& program_;
  const SolverOptions& options_;
  ProgramPoint place_;
  ProgramMultipliers multipliers_;
  InteriorOptions interior_;
  ProgramMemory memory_;
  Filter filter_;
  StepGoal goal_ = StepGoal::Objective;
  const double passed_at_first_ = place_.violation;
  double radius_ = 10;
  double unsolved_radius_ = kInfinity;  ///< of a region whose program was not solved from here
  double least_passed_ = kInfinity;     ///< where steps towards the rows last came to something
  int idle_ = 0;                        ///< such steps since then
  /// Where no step was worth anything, before steps for the multipliers alone.
  struct Settled {
    ProgramPoint place;
    ProgramMultipliers multipliers;
  };
  std::optional<Settled> settled_;
  int balances_ = 0;          ///< steps for the multipliers alone
  int inexact_ = 0;           ///< programs in a row that were not solved
  bool is_cut_ = false;       ///< whether a step was refused
  double reach_ = kInfinity;  ///< rows with more room hardly come into play
  int iterations_ = 0, evaluations_ = 1;
  std::optional<RunEnd> stopped_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

class SequentialSolver final : public Solver {
 public:
  std::string name() const override { return "sequential"; }
  bool is_global() const override { return false; }
  bool is_sharp() const override { return true; }
  std::optional<std::string> refusal(const Program&) const override { return {}; }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart* warm) const override {
    const std::span<const double> start = warm != nullptr ? warm->y : program.start();
    VectorXd y = Eigen::Map<const VectorXd>(start.data(), static_cast<Eigen::Index>(start.size()));
    for (std::size_t i = 0; i < start.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      y[at] = std::clamp(y[at], program.lower()[i], program.upper()[i]);
    }
    Sequence sequence(program, options, std::move(y));
    if (warm != nullptr) sequence.begin_with(warm->rows);
    return sequence.run();
  }
};

}  // namespace

const Solver& sequential_solver() {
  static const SequentialSolver solver;
  return solver;
}

}  // namespace camlaw::optim
