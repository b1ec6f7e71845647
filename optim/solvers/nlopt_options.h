// SPDX-License-Identifier: MIT
#pragma once

#include "optim/solvers/nlopt_methods.h"

/// NLopt's options that may be passed on. For nlopt.cpp and nlopt_search.cpp alone.
namespace camlaw::optim {

/// The options of a method, those that camlaw keeps to itself included.
std::vector<NativeRule> nlopt_rules(const NloptMethod& method);

/// Sets options that have been checked: of the method itself, or of the `helper` that does the work
/// in question (mlsl's local method). The helper may be null where the method has none.
void set_nlopt_options(const NloptMethod& method, const Program& program,
                       const NativeOptions& options, nlopt_opt opt, nlopt_opt helper);

}  // namespace camlaw::optim
