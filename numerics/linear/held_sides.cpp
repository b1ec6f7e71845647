// SPDX-License-Identifier: MIT
#include "numerics/linear/held_sides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/linear/band_order.h"
#include "numerics/linear/banded_lu.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Columns = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr Index kWidestHalf = 40;  // of a band: rows of some ten variables each

/// Changes of sides beyond this share of the rows say that the guess was of another program.
constexpr double kFewChanges = 1e-2;

/// The point at which the held sides hold, and what is left of the conditions there.
struct Held {
  VectorXd y, pushes;      ///< what the rows push with
  VectorXd values, slope;  ///< of the rows; of the Lagrangian, zero but for held variables
  bool is_balanced = false;
};

/// The conditions of optimality of variables and all rows, each row and variable as it is held:
///
///   free variable i:  (curvature y + rows^T v)_i = -cost_i,   a held one:  y_i = its bound,
///   held row r:       (rows y)_r = its bound,                 a free one:  v_r = 0.
class Conditions {
 public:
  Conditions(const QuadraticProgram& program, std::vector<Index> places, Index half)
      : program_(program),
        places_(std::move(places)),
        lu_(program.cost.size() + program.rows.rows(), half) {}

  Index variables() const { return program_.cost.size(); }
  Index rows() const { return program_.rows.rows(); }

  bool factor(const HeldSides& held) {
    const Index n = variables();
    std::vector<double> entries(static_cast<std::size_t>(lu_.places()), 0.0);
    const auto entry = [&](Index i, Index j) -> double& {
      return entries[static_cast<std::size_t>(lu_.place(at(i), at(j)))];
    };
    const auto is_held = [&](Index i) { return held.variables[static_cast<std::size_t>(i)] != 0; };
    for (Index i = 0; i < n; ++i) {
      if (is_held(i)) entry(i, i) = 1;
    }
    for (Index j = 0; j < program_.curvature.outerSize(); ++j) {
      for (Columns::InnerIterator it(program_.curvature, j); it; ++it) {
        if (!is_held(it.row())) entry(it.row(), j) = it.value();
        if (!is_held(j)) entry(j, it.row()) = it.value();
      }
    }
    for (Index r = 0; r < rows(); ++r) {
      const bool holds = held.rows[static_cast<std::size_t>(r)] != 0;
      if (!holds) entry(n + r, n + r) = 1;
      for (Rows::InnerIterator it(program_.rows, r); holds && it; ++it) {
        entry(n + r, it.col()) = it.value();
        if (!is_held(it.col())) entry(it.col(), n + r) = it.value();
      }
    }
    return lu_.factor(std::move(entries));
  }

  /// Where the conditions hold, refined for what rounding leaves.
  Held solved(const HeldSides& held) const {
    constexpr int kRefinements = 2;
    const Index n = variables(), m = rows();
    const auto side_of_variable = [&](Index i) {
      return held.variables[static_cast<std::size_t>(i)];
    };
    const auto side_of_row = [&](Index r) { return held.rows[static_cast<std::size_t>(r)]; };
    VectorXd target(n + m);
    for (Index i = 0; i < n; ++i) {
      const int side = side_of_variable(i);
      target[i] = side == 0 ? -program_.cost[i] : side > 0 ? program_.upper[i] : program_.lower[i];
    }
    for (Index r = 0; r < m; ++r) {
      const int side = side_of_row(r);
      target[n + r] = side == 0 ? 0 : side > 0 ? program_.row_upper[r] : program_.row_lower[r];
    }
    VectorXd x = solve(target);
    Held at;
    for (int refined = 0;; ++refined) {
      at = {x.head(n), x.tail(m), program_.rows * x.head(n), slope_at(x)};
      if (refined == kRefinements) break;
      VectorXd left(n + m);
      for (Index i = 0; i < n; ++i)
        left[i] = side_of_variable(i) == 0 ? -at.slope[i] : target[i] - x[i];
      for (Index r = 0; r < m; ++r)
        left[n + r] = side_of_row(r) == 0 ? -x[n + r] : target[n + r] - at.values[r];
      x += solve(left);
    }
    const VectorXd terms = program_.rows.cwiseAbs().transpose() * at.pushes.cwiseAbs();
    constexpr double kLeft = 1e-9, kTerms = 1e-6;  // as of the interior-point method
    at.is_balanced = x.allFinite();
    for (Index i = 0; i < n; ++i) {
      if (side_of_variable(i) != 0) continue;
      if (!(std::abs(at.slope[i]) <= kLeft * std::max(1.0, kTerms * terms[i])))
        at.is_balanced = false;
    }
    for (Index r = 0; r < m; ++r) {
      if (side_of_row(r) == 0) continue;
      const double size = std::max(1.0, std::abs(target[n + r]));
      if (!(std::abs(target[n + r] - at.values[r]) <= kLeft * size)) at.is_balanced = false;
    }
    return at;
  }

 private:
  VectorXd slope_at(const VectorXd& x) const {
    const Index n = variables(), m = rows();
    VectorXd slope = program_.cost + program_.rows.transpose() * x.tail(m);
    if (program_.curvature.size() > 0)
      slope += program_.curvature.selfadjointView<Eigen::Lower>() * x.head(n);
    return slope;
  }

  /// The variables, then what the rows push with.
  VectorXd solve(const VectorXd& target) const {
    VectorXd ordered(target.size()), result(target.size());
    for (Index i = 0; i < target.size(); ++i) ordered[at(i)] = target[i];
    ordered = lu_.solve(std::move(ordered));
    for (Index i = 0; i < target.size(); ++i) result[i] = ordered[at(i)];
    return result;
  }

  Index at(Index unknown) const { return places_[static_cast<std::size_t>(unknown)]; }

  const QuadraticProgram& program_;
  std::vector<Index> places_;
  BandedLu lu_;
};

/// Where the unknowns are in the band of the conditions, and half its width.
struct Band {
  std::vector<Index> places;
  Index half = 0;
};

Band band_of(const QuadraticProgram& program) {
  const Index n = program.cost.size(), m = program.rows.rows();
  std::vector<Eigen::Triplet<double>> triplets;
  const auto add = [&](Index i, Index j) {
    triplets.emplace_back(i, j, 1.0);
    if (i != j) triplets.emplace_back(j, i, 1.0);
  };
  for (Index i = 0; i < n + m; ++i) add(i, i);
  for (Index r = 0; r < m; ++r) {
    for (Rows::InnerIterator it(program.rows, r); it; ++it) add(n + r, it.col());
  }
  for (Index j = 0; j < program.curvature.outerSize(); ++j) {
    for (Columns::InnerIterator it(program.curvature, j); it; ++it) add(it.row(), j);
  }
  Columns matrix(n + m, n + m);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  const std::vector<int> order = band_order(matrix);
  Band band{std::vector<Index>(order.size())};
  const auto place = [&](int unknown) -> Index& {
    return band.places[static_cast<std::size_t>(unknown)];
  };
  for (std::size_t k = 0; k < order.size(); ++k) place(order[k]) = static_cast<Index>(k);
  for (const auto& t : triplets)
    band.half = std::max(band.half, std::abs(place(t.row()) - place(t.col())));
  return band;
}

/// Lets go of sides that would have to pull, and holds those that are passed; how many.
Index changed(const QuadraticProgram& program, const Held& at, HeldSides& held) {
  constexpr double kPassed = 1e-10, kPulled = 1e-12;
  Index changes = 0;
  const auto change = [&](signed char& side, double push, double value, double lower,
                          double upper) {
    const int before = side;
    if (side != 0 && side * push < -kPulled) {
      side = 0;
    } else if (side == 0 && value - upper > kPassed) {
      side = 1;
    } else if (side == 0 && lower - value > kPassed) {
      side = -1;
    }
    if (side != before) ++changes;
  };
  for (Index i = 0; i < at.y.size(); ++i)
    change(held.variables[static_cast<std::size_t>(i)], -at.slope[i], at.y[i], program.lower[i],
           program.upper[i]);
  for (Index r = 0; r < at.values.size(); ++r) {
    if (program.row_lower[r] == program.row_upper[r]) continue;
    change(held.rows[static_cast<std::size_t>(r)], at.pushes[r], at.values[r], program.row_lower[r],
           program.row_upper[r]);
  }
  return changes;
}

InteriorSolution with_multipliers(const Held& at, const HeldSides& held, int steps) {
  const Index n = at.y.size();
  InteriorSolution solution{at.y, at.pushes, VectorXd::Zero(n), VectorXd::Zero(n)};
  for (Index i = 0; i < n; ++i) {
    const int side = held.variables[static_cast<std::size_t>(i)];
    if (side > 0) solution.upper_multipliers[i] = std::max(0.0, -at.slope[i]);
    if (side < 0) solution.lower_multipliers[i] = std::max(0.0, at.slope[i]);
  }
  solution.end = InteriorEnd::Optimal;
  solution.iterations = steps;
  return solution;
}

}  // namespace

bool has_local_rows(const QuadraticProgram& program) {
  return band_of(program).half <= kWidestHalf;
}

HeldSides held_sides(const QuadraticProgram& program, const InteriorSolution& solution) {
  HeldSides held;
  const VectorXd values = program.rows * solution.y;
  for (Index r = 0; r < values.size(); ++r) {
    const double z = solution.row_multipliers[r];
    const double room = z > 0 ? program.row_upper[r] - values[r] : values[r] - program.row_lower[r];
    const bool is_equation = program.row_lower[r] == program.row_upper[r];
    const bool holds = is_equation || std::abs(z) > room;
    held.rows.push_back(static_cast<signed char>(!holds ? 0 : z > 0 ? 1 : -1));
  }
  for (Index i = 0; i < solution.y.size(); ++i) {
    const bool upper = solution.upper_multipliers[i] > program.upper[i] - solution.y[i];
    const bool lower = solution.lower_multipliers[i] > solution.y[i] - program.lower[i];
    held.variables.push_back(static_cast<signed char>(upper ? 1 : lower ? -1 : 0));
  }
  return held;
}

std::optional<InteriorSolution> solve_from_held_sides(const QuadraticProgram& program,
                                                      HeldSides held) {
  constexpr int kMostSteps = 5;
  Band band = band_of(program);
  if (band.half > kWidestHalf) return {};
  Conditions system(program, std::move(band.places), band.half);
  const auto few = static_cast<Index>(10 + kFewChanges * static_cast<double>(held.rows.size()));
  for (int step = 1; step <= kMostSteps; ++step) {
    if (!system.factor(held)) return {};
    const Held at = system.solved(held);
    const Index changes = changed(program, at, held);
    if (changes > few) return {};
    if (changes > 0) continue;
    if (!at.is_balanced) return {};
    return with_multipliers(at, held, step);
  }
  return {};
}

}  // namespace camlaw::optim
