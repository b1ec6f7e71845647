// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "optim/problem/function.h"

namespace camlaw::problems {

/// A kernel applied to design variables in any order, of which one may stand behind several
/// arguments: variables[k] is that of argument k.
optim::Function function_of(const std::vector<std::size_t>& variables,
                            std::shared_ptr<const optim::Kernel> kernel, optim::Shape shape);

/// The arguments at a design.
std::vector<double> arguments_at(const std::vector<std::size_t>& variables, optim::Design x);

}  // namespace camlaw::problems
