// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "numerics/formula/formula_text.h"

namespace camlaw {

/// How a name of a formula is set.
using LatexOfName = std::function<std::string(const std::string& name)>;

/// A formula as LaTeX sets it for people: fractions, roots, powers. Parentheses are those that the
/// setting needs.
std::string latex_of(const FormulaTree& tree, const LatexOfName& latex_of_name);

/// A symbol such as "F_0", "mu" or "R1" as LaTeX: F_{0}, \mu, R_{1}.
std::string latex_symbol(const std::string& symbol);

}  // namespace camlaw
