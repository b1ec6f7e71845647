// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <vector>

/// Linear and convex quadratic programs of many variables whose rows are local, each in a few of
/// them.
namespace camlaw::optim {

/// minimise cost . y + y . curvature y / 2 where row_lower <= rows y <= row_upper and lower <= y <=
/// upper. Bounds may be infinite.
struct QuadraticProgram {
  Eigen::VectorXd cost;
  /// Lower triangle, with no negative eigenvalue; of size 0 where the program is linear.
  Eigen::SparseMatrix<double> curvature = {};
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows;
  Eigen::VectorXd row_lower, row_upper, lower, upper;
};

/// How an interior-point method ends.
enum class InteriorEnd {
  Optimal,         ///< to about ten digits
  Acceptable,      ///< no more progress, but optimal to about seven digits
  Stalled,         ///< no more progress
  IterationLimit,  ///< more iterations than were allowed
  Ended            ///< by the one who watched
};

/// A point on the way of a method, from which a program that differs little may begin. Slacks and
/// multipliers are those of the rows' bounds, then of the variables', each lower one before its
/// upper one; zero where there is no such bound.
struct InteriorStage {
  double gap = 0;  ///< the sum of slacks times multipliers
  Eigen::VectorXd y, slacks, multipliers;
};

/// A point with its multipliers. At an optimum cost + curvature y + rows^T row_multipliers -
/// lower_multipliers + upper_multipliers is zero. Multipliers of bounds are not negative; that of a
/// row is positive where its upper bound holds it, negative where the lower one does.
struct InteriorSolution {
  Eigen::VectorXd y, row_multipliers, lower_multipliers, upper_multipliers;
  InteriorEnd end = InteriorEnd::Stalled;
  int iterations = 0;
  bool is_augmented = false;  ///< whether it was found with variables and rows together
  std::vector<InteriorStage> stages = {};  ///< where the gap had lost another digit, if asked for
};

struct InteriorOptions {
  int most_iterations = 200;
  /// A solution of a linear program that differed in a few rows, to begin near: it need not be one
  /// of this program, but its multipliers are those of this program's rows and bounds.
  const InteriorSolution* near = nullptr;
  /// The gap counts over the objective's magnitude, but over no less than this.
  double least_objective = 1e-2;
  /// Without a try of the normal equations, where there is another system.
  bool begins_augmented = false;
  /// Where to begin in place of the start, if anywhere. A bound of which it has nothing begins with
  /// the slack of a start.
  const InteriorStage* stage = nullptr;
  bool keeps_stages = false;
  /// Ends at the solution of the sides that hold, as soon as they are seen to meet the conditions
  /// of optimality by themselves (held_sides.h): for programs of local rows with one solution.
  bool settles = false;
  /// Asked after each iteration with its number, the objective and the largest residual of a row,
  /// over a millionth of its terms' sum where that is more than 1: whether to go on.
  std::function<bool(int, double, double)> goes_on = {};
};

/// Mehrotra's predictor and corrector (1992) on sparse normal equations, and where these lose too
/// many digits on variables and rows together (docs/optimisation.md, (XM3), (XM5)). Rows and costs
/// are to be scaled so that changes of order one count. Rows whose bounds are equal are equations,
/// which are to be few; no variable may have equal bounds, and each is to be in an inequality.
/// Stalls at once where there is no inequality at all.
InteriorSolution solve_by_interior_point(const QuadraticProgram& program,
                                         const Eigen::VectorXd& start,
                                         const InteriorOptions& options = {});

}  // namespace camlaw::optim
