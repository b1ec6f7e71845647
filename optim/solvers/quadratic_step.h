// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <cmath>
#include <optional>
#include <vector>

#include "numerics/linear/held_sides.h"
#include "numerics/linear/quadratic_program.h"
#include "optim/solvers/program.h"

/// Steps of a nonlinear program by convex quadratic ones (docs/optimisation.md, (XM4)).
namespace camlaw::optim {

/// A design with what the program's functions say there.
struct ProgramPoint {
  Eigen::VectorXd y;
  double objective = 0;
  Eigen::VectorXd rows;
  double violation = 0;  ///< the largest of a row

  bool is_finite() const { return std::isfinite(objective) && rows.allFinite(); }
};

ProgramPoint point_at(const Program& program, Eigen::VectorXd y);

/// ProgramMultipliers with Ipopt's signs (WarmStart).
struct ProgramMultipliers {
  Eigen::VectorXd rows, lower, upper;
};

/// Gradients and curvature at a point: what its quadratic programs are made of.
struct LocalModel {
  Eigen::VectorXd gradient;
  Eigen::SparseMatrix<double, Eigen::RowMajor> jacobian;
  Eigen::SparseMatrix<double> curvature;  ///< lower triangle, no negative eigenvalue

  bool is_finite() const {
    const Eigen::Map<const Eigen::VectorXd> entries(jacobian.valuePtr(), jacobian.nonZeros());
    const Eigen::Map<const Eigen::VectorXd> bends(curvature.valuePtr(), curvature.nonZeros());
    return gradient.allFinite() && entries.allFinite() && bends.allFinite();
  }
  double change(const Eigen::VectorXd& d) const {
    return gradient.dot(d) + 0.5 * d.dot(curvature.selfadjointView<Eigen::Lower>() * d);
  }
};

LocalModel model_at(const Program& program, const ProgramPoint& point,
                    const Eigen::VectorXd& row_multipliers);

/// A step, by how much rows pass their bounds after it to first order, and the multipliers.
struct ProgramStep {
  Eigen::VectorXd d;
  double passed = 0;
  ProgramMultipliers multipliers;
  bool is_exact = true;  ///< whether its program was solved

  double length() const { return d.lpNorm<Eigen::Infinity>(); }
};

/// A bound of a row: its number, and 1 for its upper bound, -1 for the lower one; 0 for both of an
/// equation.
struct RowSide {
  Eigen::Index row;
  double sign;
};

/// What a step is for: the objective within the rows, or the rows alone, in as far as they can be
/// met.
enum class StepGoal { Objective, Rows };

/// What a quadratic program leaves for the next ones, which differ little from it as steps become
/// small. Rows and bounds are numbered as the nonlinear program's.
struct ProgramMemory {
  HeldSides held;                     ///< what held its solution; empty where there is none
  std::optional<bool> is_local;       ///< whether rows are, once it is known
  bool is_augmented = false;          ///< whether normal equations have lost too many digits
  std::vector<InteriorStage> stages;  ///< where y counts from the point of now
  /// How wrong the program was about the objective, rows by their multipliers included: a gap that
  /// is smaller was closed in vain.
  double unforeseen = 0;

  void moved(const Eigen::VectorXd& d) {
    for (InteriorStage& stage : stages) stage.y -= d;
  }
};

/// The quadratic programs of a point, in the step. If the rows are the goal there is one more
/// variable, by which any row may pass its bounds: so that there always is a step.
class Quadratics {
  /// Of the largest multiplier: less is an idle row's, or an idle bound's.
  static constexpr double kIdle = 1e-11;

 public:
  /// Sides with more room than `reach` come into a program only where its step passes them.
  Quadratics(const Program& program, const LocalModel& model, double reach, ProgramMemory& memory);
  /// The step from a point whose rows are these there, no farther than the radius; none where the
  /// interior-point method finds none.
  std::optional<ProgramStep> step(const Eigen::VectorXd& y, const Eigen::VectorXd& rows,
                                  double radius, StepGoal goal, const InteriorOptions& options);

 private:
  /// The program as it stands, from what is remembered of another.
  InteriorSolution solved(const Eigen::VectorXd& start, double radius, InteriorOptions options);
  void remember(InteriorSolution& found);
  /// Of the bound of a row or variable of the quadratic program, as those of stages: the nonlinear
  /// one's number.
  Eigen::Index original(Eigen::Index bound) const;
  std::optional<InteriorStage> stage(double radius) const;
  double bound(const RowSide& side) const;
  double room(const RowSide& side, const Eigen::VectorXd& rows) const;
  /// If the rows are the goal an equation has two sides.
  std::vector<RowSide> chosen(const std::vector<bool>& is_near, StepGoal goal) const;
  /// Whether a step passes sides that its program did not have by more than is allowed; they are
  /// near from then on.
  bool added_passed(const Eigen::VectorXd& after, double allowed, std::vector<bool>& is_near) const;
  void set_costs(StepGoal goal);
  void set_region(const Eigen::VectorXd& y, double radius, StepGoal goal);
  void set_rows(const std::vector<RowSide>& near, const Eigen::VectorXd& rows, StepGoal goal);
  /// No step, and what the rows are passed by.
  Eigen::VectorXd start(const Eigen::VectorXd& rows) const;
  ProgramStep read(const InteriorSolution& found, double radius) const;

  const Program& program_;
  const LocalModel& model_;
  double reach_;
  ProgramMemory& memory_;
  std::vector<RowSide> sides_;
  QuadraticProgram quadratic_;
  std::vector<Eigen::Index> near_rows_;  ///< the program's, by those of the quadratic one
};

}  // namespace camlaw::optim
