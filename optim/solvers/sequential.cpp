// SPDX-License-Identifier: MIT
#include "optim/solvers/sequential.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "numerics/linear/quadratic_program.h"
#include "optim/solvers/read_off.h"
#include "optim/solvers/run_end.h"

namespace camlaw::optim {
namespace {

using Eigen::VectorXd;

/// A design with what the program's functions say there.
struct Place {
  VectorXd y;
  double objective = 0;
  VectorXd rows;
  double violation = 0;  ///< the largest of a row

  bool is_finite() const { return std::isfinite(objective) && rows.allFinite(); }
};

std::span<const double> as_span(const VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

double largest_violation_of(const Program& program, const VectorXd& rows) {
  double worst = 0;
  for (std::size_t r = 0; r < program.rows(); ++r) {
    const double value = rows[static_cast<Eigen::Index>(r)];
    worst = std::max({worst, value - program.row_upper()[r], program.row_lower()[r] - value});
  }
  return worst;
}

Place place_at(const Program& program, VectorXd y) {
  Place place{std::move(y), 0, VectorXd(static_cast<Eigen::Index>(program.rows())), 0};
  place.objective = program.objective(as_span(place.y));
  program.row_values(as_span(place.y), {place.rows.data(), program.rows()});
  place.violation = largest_violation_of(program, place.rows);
  return place;
}

/// Multipliers with Ipopt's signs (WarmStart).
struct Multipliers {
  VectorXd rows, lower, upper;
};

/// Gradients and curvature at a place: what its quadratic programs are made of.
struct Model {
  VectorXd gradient;
  Eigen::SparseMatrix<double, Eigen::RowMajor> jacobian;
  Eigen::SparseMatrix<double> curvature;  ///< lower triangle, no negative eigenvalue

  bool is_finite() const {
    const Eigen::Map<const VectorXd> entries(jacobian.valuePtr(), jacobian.nonZeros());
    const Eigen::Map<const VectorXd> bends(curvature.valuePtr(), curvature.nonZeros());
    return gradient.allFinite() && entries.allFinite() && bends.allFinite();
  }
  double change(const VectorXd& d) const {
    return gradient.dot(d) + 0.5 * d.dot(curvature.selfadjointView<Eigen::Lower>() * d);
  }
};

/// Curvature that decides among steps that are worth the same.
constexpr double kProximal = 1e-9;

Model model_at(const Program& program, const Place& place, const VectorXd& row_multipliers) {
  const auto n = static_cast<Eigen::Index>(program.variables());
  Model model;
  model.gradient.resize(n);
  program.gradient(as_span(place.y), {model.gradient.data(), program.variables()});
  model.jacobian = jacobian_matrix(program, as_span(place.y));
  const Pattern& pattern = program.hessian_pattern();
  std::vector<double> entries(pattern.size());
  program.convex_hessian(as_span(place.y), 1, as_span(row_multipliers), entries);
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size() + program.variables());
  for (std::size_t k = 0; k < entries.size(); ++k)
    triplets.emplace_back(pattern.rows[k], pattern.columns[k], entries[k]);
  for (int i = 0; i < n; ++i) triplets.emplace_back(i, i, kProximal);
  model.curvature.resize(n, n);
  model.curvature.setFromTriplets(triplets.begin(), triplets.end());
  return model;
}

/// A step, by how much rows pass their bounds after it to first order, and the multipliers.
struct Step {
  VectorXd d;
  double passed = 0;
  Multipliers multipliers;
  bool is_exact = true;  ///< whether its program was solved

  double length() const { return d.lpNorm<Eigen::Infinity>(); }
};

/// A bound of a row: its number, and 1 for its upper bound, -1 for the lower one; 0 for both of an
/// equation.
struct Side {
  Eigen::Index row;
  double sign;
};

/// What a step is for: the objective within the rows, or the rows alone, in as far as they can be
/// met.
enum class Goal { Objective, Rows };

/// The quadratic programs of a place, in the step. If the rows are the goal there is one more
/// variable, by which any row may pass its bounds: so that there always is a step.
class Quadratics {
  /// Of the largest multiplier: less is an idle row's, or an idle bound's.
  static constexpr double kIdle = 1e-11;

 public:
  /// Sides with more room than `reach` come into a program only where its step passes them.
  Quadratics(const Program& program, const Model& model, double reach)
      : program_(program), model_(model), reach_(reach) {
    const auto m = static_cast<Eigen::Index>(program.rows());
    for (Eigen::Index r = 0; r < m; ++r) {
      const auto row = static_cast<std::size_t>(r);
      if (program.row_is_equation(row)) {
        sides_.push_back({r, 0});
        continue;
      }
      if (std::isfinite(program.row_upper()[row])) sides_.push_back({r, 1});
      if (std::isfinite(program.row_lower()[row])) sides_.push_back({r, -1});
    }
  }

  /// The step from a place whose rows are these there, no farther than the radius; none where the
  /// interior-point method finds none.
  std::optional<Step> step(const VectorXd& y, const VectorXd& rows, double radius, Goal goal,
                           const InteriorOptions& options) {
    set_costs(goal);
    set_region(y, radius, goal);
    std::vector<bool> is_near(sides_.size());
    for (std::size_t k = 0; k < sides_.size(); ++k) is_near[k] = room(sides_[k], rows) <= reach_;
    while (true) {
      const std::vector<Side> near = chosen(is_near, goal);
      set_rows(near, rows, goal);
      const InteriorSolution found = solve_by_interior_point(quadratic_, start(rows), options);
      if (found.end == InteriorEnd::Ended || !found.y.allFinite()) return {};
      Step step = read(found, near, radius);
      const VectorXd after = rows + model_.jacobian * step.d;
      step.passed = largest_violation_of(program_, after);
      step.is_exact = found.end == InteriorEnd::Optimal || found.end == InteriorEnd::Acceptable;
      const double allowed = goal == Goal::Rows ? std::max(0.0, found.y[found.y.size() - 1]) : 0;
      if (added_passed(after, allowed, is_near)) continue;
      // One that is not exact is a step all the same, as long as it does what rows ask for.
      constexpr double kMet = 1e-8;
      return goal == Goal::Rows || step.passed <= kMet ? std::optional(std::move(step))
                                                       : std::nullopt;
    }
  }

 private:
  double bound(const Side& side) const {
    const auto row = static_cast<std::size_t>(side.row);
    return side.sign >= 0 ? program_.row_upper()[row] : program_.row_lower()[row];
  }
  double room(const Side& side, const VectorXd& rows) const {
    const double left = bound(side) - rows[side.row];
    return side.sign == 0 ? -std::abs(left) : side.sign * left;
  }
  /// If the rows are the goal an equation has two sides.
  std::vector<Side> chosen(const std::vector<bool>& is_near, Goal goal) const {
    std::vector<Side> near;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      if (!is_near[k]) continue;
      if (sides_[k].sign == 0 && goal == Goal::Rows) {
        near.push_back({sides_[k].row, 1});
        near.push_back({sides_[k].row, -1});
      } else {
        near.push_back(sides_[k]);
      }
    }
    return near;
  }

  /// Whether a step passes sides that its program did not have by more than is allowed; they are
  /// near from then on.
  bool added_passed(const VectorXd& after, double allowed, std::vector<bool>& is_near) const {
    constexpr double kPassed = 1e-10;
    bool any = false;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      if (is_near[k] || room(sides_[k], after) >= -allowed - kPassed) continue;
      is_near[k] = true;
      any = true;
    }
    return any;
  }

  void set_costs(Goal goal) {
    const auto n = static_cast<Eigen::Index>(program_.variables());
    if (goal == Goal::Objective) {
      quadratic_.cost = model_.gradient;
      quadratic_.curvature = model_.curvature;
      return;
    }
    quadratic_.cost = VectorXd::Zero(n + 1);
    quadratic_.cost[n] = 1;
    quadratic_.curvature.resize(n + 1, n + 1);
    for (Eigen::Index i = 0; i < n; ++i) quadratic_.curvature.insert(i, i) = kProximal;
  }

  void set_region(const VectorXd& y, double radius, Goal goal) {
    const auto n = static_cast<Eigen::Index>(program_.variables());
    const Eigen::Index columns = n + (goal == Goal::Rows ? 1 : 0);
    quadratic_.lower = VectorXd::Zero(columns);
    quadratic_.upper = VectorXd::Constant(columns, kInfinity);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      quadratic_.lower[i] = std::max(-radius, std::min(0.0, program_.lower()[at] - y[i]));
      quadratic_.upper[i] = std::min(radius, std::max(0.0, program_.upper()[at] - y[i]));
    }
  }

  void set_rows(const std::vector<Side>& near, const VectorXd& rows, Goal goal) {
    const auto n = static_cast<Eigen::Index>(program_.variables());
    const auto count = static_cast<Eigen::Index>(near.size());
    quadratic_.rows.resize(count, quadratic_.cost.size());
    quadratic_.rows.reserve(2 * model_.jacobian.nonZeros() + count);
    quadratic_.row_lower = VectorXd::Constant(count, -kInfinity);
    quadratic_.row_upper = VectorXd::Constant(count, kInfinity);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Side& side = near[static_cast<std::size_t>(k)];
      quadratic_.rows.startVec(k);
      using Entry = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
      for (Entry entry(model_.jacobian, side.row); entry; ++entry)
        quadratic_.rows.insertBack(k, entry.col()) = entry.value();
      if (goal == Goal::Rows) quadratic_.rows.insertBack(k, n) = -side.sign;
      const double level = bound(side) - rows[side.row];
      if (side.sign >= 0) quadratic_.row_upper[k] = level;
      if (side.sign <= 0) quadratic_.row_lower[k] = level;
    }
    quadratic_.rows.finalize();
  }

  /// No step, and what the rows are passed by.
  VectorXd start(const VectorXd& rows) const {
    VectorXd start = VectorXd::Zero(quadratic_.cost.size());
    if (start.size() > static_cast<Eigen::Index>(program_.variables()))
      start[start.size() - 1] = largest_violation_of(program_, rows);
    return start;
  }

  Step read(const InteriorSolution& found, const std::vector<Side>& near, double radius) const {
    const auto n = static_cast<Eigen::Index>(program_.variables());
    Step step{found.y.head(n), 0, {}};
    const auto largest = [](const VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); };
    const double idle =
        kIdle * std::max({largest(found.row_multipliers), largest(found.lower_multipliers),
                          largest(found.upper_multipliers)});
    step.multipliers.rows = VectorXd::Zero(static_cast<Eigen::Index>(program_.rows()));
    for (std::size_t k = 0; k < near.size(); ++k) {
      const double multiplier = found.row_multipliers[static_cast<Eigen::Index>(k)];
      if (std::abs(multiplier) > idle) step.multipliers.rows[near[k].row] += multiplier;
    }
    step.multipliers.lower = found.lower_multipliers.head(n);
    step.multipliers.upper = found.upper_multipliers.head(n);
    for (Eigen::Index i = 0; i < n; ++i) {  // the trust region's are not the program's
      double &lower = step.multipliers.lower[i], &upper = step.multipliers.upper[i];
      if (quadratic_.lower[i] == -radius || lower <= idle) lower = 0;
      if (quadratic_.upper[i] == radius || upper <= idle) upper = 0;
      step.d[i] = std::clamp(step.d[i], quadratic_.lower[i], quadratic_.upper[i]);
    }
    return step;
  }

  const Program& program_;
  const Model& model_;
  double reach_;
  std::vector<Side> sides_;
  QuadraticProgram quadratic_;
};

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
    constexpr double kMargin = 1e-5;
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
      : program_(program), options_(options), place_(place_at(program, std::move(y))), met_(1e-9) {
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
    constexpr int kMost = 100;
    if (!place_.is_finite()) return answer(Status::NonFiniteStart, "not a number at the start");
    while (iterations_ < options_.max_iterations) {
      if (iterations_ >= kMost) return answer(Status::Stalled, "the steps do not come to an end");
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
        return answer(Status::Stalled, "no step leads on");
      if (place_.violation <= met_ && is_far_out(program_, as_span(place_.y)))
        return answer(Status::Unbounded, "the objective falls without end");
      if (advance == Advance::Last) {
        if (place_.violation > met_) return answer(Status::Infeasible, "no step meets the rows");
        return answer(Status::Solved, "no step is worth anything");
      }
    }
    return answer(Status::IterationLimit, "limit of iterations");
  }

 private:
  enum class Advance { Some, Last, None, Undefined };
  static constexpr double kLastStep = 1e-6;   // of a variable: Newton's next would be rounding
  static constexpr double kRounding = 1e-11;  // of an objective: what it changes by says nothing

  /// The place after a step, on whose way no variable passes a bound by rounding.
  Place moved(const VectorXd& d) {
    ++evaluations_;
    VectorXd y = place_.y + d;
    for (std::size_t i = 0; i < program_.variables(); ++i) {
      double& at = y[static_cast<Eigen::Index>(i)];
      at = std::clamp(at, program_.lower()[i], program_.upper()[i]);
    }
    return place_at(program_, std::move(y));
  }
  double rounding() const { return kRounding * (1 + std::abs(place_.objective)); }
  /// Of a place; what is met is met.
  double passed(const Place& place) const { return place.violation <= met_ ? 0 : place.violation; }

  /// One step that is worth taking, from models of the place where it stands.
  Advance advanced() {
    constexpr double kLeastRadius = 1e-10;
    const Model model = model_at(program_, place_, multipliers_.rows);
    if (!model.is_finite()) return Advance::Undefined;
    Quadratics quadratics(program_, model, reach_);
    unsolved_radius_ = kInfinity;
    while (radius_ > kLeastRadius) {
      const auto advance =
          goal_ == Goal::Rows ? restored(model, quadratics) : improved(model, quadratics);
      if (ended()) return Advance::None;
      if (advance) return *advance;
    }
    return Advance::None;
  }

  void cut_region(double length) {
    radius_ = kShrink * std::min(radius_, length);
    is_cut_ = true;
  }

  /// A step towards rows that are met; none where it is refused, or the rows can be met after all.
  std::optional<Advance> restored(const Model& model, Quadratics& quadratics) {
    constexpr double kGood = 0.1, kWorth = 1e-3;
    const auto step = quadratics.step(place_.y, place_.rows, radius_, Goal::Rows, interior_);
    if (!step) {
      cut_region(radius_);
      return {};
    }
    if (step->passed <= met_) {
      // Where the method has not solved the objective's program in this region, a smaller one.
      if (radius_ >= unsolved_radius_) cut_region(radius_);
      goal_ = Goal::Objective;
      return {};
    }
    const double promised = place_.violation - step->passed;
    if (promised <= kWorth * met_ || promised <= kRounding * place_.violation)
      return step->length() < kAtEdge * radius_ ? Advance::Last : Advance::None;
    Place trial = moved(step->d);
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
    constexpr int kPatience = 15;
    constexpr double kLess = 0.9;
    if (violation < kLess * least_passed_) {
      least_passed_ = violation;
      idle_ = 0;
    }
    return ++idle_ > kPatience;
  }

  /// A step to a better objective within the rows, or the same corrected for how rows bend.
  std::optional<Advance> improved(const Model& model, Quadratics& quadratics) {
    const auto step = quadratics.step(place_.y, place_.rows, radius_, Goal::Objective, interior_);
    if (!step) {
      if (ended()) return Advance::None;
      unsolved_radius_ = radius_;
      goal_ = Goal::Rows;
      return {};
    }
    constexpr int kMostInexact = 4;
    inexact_ = step->is_exact ? 0 : inexact_ + 1;
    if (inexact_ > kMostInexact) return Advance::None;
    const double promised = -model.change(step->d);
    // A step that a small region cut short says nothing.
    constexpr double kSmall = 1e-3;
    const bool is_inside = step->length() < kAtEdge * radius_;
    const bool is_short = step->length() <= kLastStep && is_inside;
    const bool is_worthless = std::abs(promised) <= rounding() && (is_inside || radius_ >= kSmall);
    Place trial = moved(step->d);
    if (is_short || (passed(place_) == 0 && is_worthless)) {
      const bool holds = trial.is_finite() && trial.violation <= std::max(place_.violation, met_);
      multipliers_ = step->multipliers;
      if (holds) place_ = std::move(trial);
      return passed(place_) == 0 ? Advance::Last : Advance::None;
    }
    if (is_good(trial, promised)) return taken(std::move(trial), model, *step, promised);
    if (trial.is_finite()) {
      const VectorXd bent = trial.rows - model.jacobian * step->d;
      const auto second = quadratics.step(place_.y, bent, radius_, Goal::Objective, interior_);
      if (second) {
        Place corrected = moved(second->d);
        if (is_good(corrected, promised))
          return taken(std::move(corrected), model, *second, promised);
      }
    }
    cut_region(step->length());
    return {};
  }

  /// Whether the objective falls by a good part of what the model says, if it says that it falls by
  /// more than the rows are worth; else whether the filter takes the place.
  bool is_good(const Place& trial, double promised) const {
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
    const double before = passed(place_);
    return promised > 0 && promised >= 1e-4 * before * before && promised > rounding();
  }

  Advance taken(Place trial, const Model& model, const Step& step, double promised) {
    const double gained = place_.objective - trial.objective;
    const bool at_edge = step.length() >= kAtEdge * radius_;
    // Where the model tells objective and rows to rounding the next step will be worth nothing.
    const VectorXd bends = trial.rows - place_.rows - model.jacobian * step.d;
    const double unforeseen =
        std::abs(promised - gained) + step.multipliers.rows.cwiseAbs().dot(bends.cwiseAbs());
    const bool last = unforeseen <= rounding() && !at_edge && passed(trial) == 0;
    if (is_about_objective(promised)) {
      grow_region(gained / promised, step);
    } else {
      filter_.add(passed(place_), place_.objective);
      grow_region(1, step);
    }
    multipliers_ = step.multipliers;
    go_to(std::move(trial), model, step.d);
    return last ? Advance::Last : Advance::Some;
  }

  /// After a step to its edge that kept its promise. A region that a step had to be cut to is near
  /// what the models are good for.
  void grow_region(double share, const Step& step) {
    constexpr double kMostRadius = 1e6;
    struct Growth {
      double least_share, factor;
    };
    constexpr Growth kAtFirst{0.5, 4}, kLater{0.8, 1.5};
    const Growth& growth = is_cut_ ? kLater : kAtFirst;
    if (share >= growth.least_share && step.length() >= kAtEdge * radius_)
      radius_ = std::min(kMostRadius, growth.factor * radius_);
  }

  void go_to(Place trial, const Model& model, const VectorXd& d) {
    constexpr double kReach = 2;
    reach_ = kReach * (model.jacobian * d).lpNorm<Eigen::Infinity>();
    place_ = std::move(trial);
  }

  bool ended() {
    if (is_stopped(options_)) stopped_ = RunEnd{Status::Stopped, "stopped"};
    if (is_late(options_, began_)) stopped_ = RunEnd{Status::TimeLimit, "time limit"};
    return stopped_.has_value();
  }

  Solution answer(Status status, std::string message) const {
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

  static constexpr double kShrink = 0.5, kAtEdge = 0.9, kWarmReach = 1e-2;

  const Program& program_;
  const SolverOptions& options_;
  Place place_;
  Multipliers multipliers_;
  InteriorOptions interior_;
  Filter filter_;
  Goal goal_ = Goal::Objective;
  double met_;  ///< a row passed by less, by its size, is met
  const double passed_at_first_ = place_.violation;
  double radius_ = 10;
  double unsolved_radius_ = kInfinity;  ///< of a region whose program was not solved from here
  double least_passed_ = kInfinity;     ///< where steps towards the rows last came to something
  int idle_ = 0;                        ///< such steps since then
  int inexact_ = 0;                     ///< programs in a row that were not solved
  bool is_cut_ = false;                 ///< whether a step was refused
  double reach_ = kInfinity;            ///< rows with more room hardly come into play
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
