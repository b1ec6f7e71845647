// SPDX-License-Identifier: MIT
#pragma once

#include <IpIpoptApplication.hpp>

#include "optim/solvers/solver.h"

/// Ipopt's options: those that camlaw sets and those that may be passed on. For ipopt.cpp alone.
namespace camlaw::optim {

/// Every option that Ipopt registers, with what it accepts.
const std::vector<NativeRule>& ipopt_rules();

/// What camlaw sets, then the native options, which have been checked. `warm`: whether the run
/// begins with multipliers.
void set_ipopt_options(Ipopt::OptionsList& list, const SolverOptions& options, bool warm);

}  // namespace camlaw::optim
