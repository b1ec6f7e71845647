// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/problem/problem.h"
#include "optim/solvers/solver.h"

namespace camlaw::optim {

/// A linear problem of more variables goes to the interior-point method first: where limits leave
/// room, its answers stay amid it, and vertices pass them in many places that the exchange has to
/// add one by one.
inline constexpr std::size_t kManyVariables = 30;

/// Whether objective and limits are known to be linear.
bool is_linear(const Problem& problem);

/// The methods to try in turn, and why.
struct Plan {
  std::vector<const Solver*> solvers;
  std::string why;
};

/// `wanted` is a name of solver_names() or "auto": for linear problems clp, of many variables
/// interior before it; else up to 30 variables and limits slsqp, then ipopt where the conditions of
/// optimality do not hold; beyond, ipopt.
Plan plan(const Problem& problem, const std::string& wanted);

/// For the design of least violation: each where those before it do not convince.
std::vector<const Solver*> least_violation_plan(const Problem& problem);

}  // namespace camlaw::optim
