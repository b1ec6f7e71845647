// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/problem/problem.h"
#include "optim/solvers/solver.h"

namespace camlaw::optim {

/// Whether a problem has many variables, or several whose bounds lie far apart beside a typical
/// change, as those of a free law's coefficients. Then points drawn at random are of little use as
/// starts, a nonlinear problem goes to the sequential method, and a sharp optimum is not polished.
bool is_large(const Problem& problem);

/// Whether objective and limits are known to be linear.
bool is_linear(const Problem& problem);

/// The methods to try in turn, and why.
struct Plan {
  std::vector<const Solver*> solvers;
  std::string why;
};

/// `wanted` is a name of solver_names() or "auto": for linear problems interior, then clp; else up
/// to 30 variables and limits slsqp, then ipopt where the conditions of optimality do not hold;
/// of large ones sequential, then ipopt; of more limits ipopt. Interior comes before clp because
/// its answers stay amid the room that limits leave; vertices pass curves' limits in many places,
/// which the exchange has to add one by one. Up to 30 variables without curves go to clp first.
Plan plan(const Problem& problem, const std::string& wanted);

/// For the design of least violation: each where those before it do not convince.
std::vector<const Solver*> least_violation_plan(const Problem& problem);

}  // namespace camlaw::optim
