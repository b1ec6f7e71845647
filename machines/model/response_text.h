// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// The formula of a response as it is recorded, over several lines, in the grammar of
/// docs/formulas.md: quantities in the units of the SI, angles in rad. Throws std::invalid_argument
/// where the response is not a formula.
std::string formula_text(const Mechanism& mechanism, const MechanismResponse& response);

/// The same in LaTeX, "\begin{aligned} ... \end{aligned}": parameters by their symbols, of the law
/// s and its derivatives. Throws as formula_text.
std::string formula_latex(const Mechanism& mechanism, const MechanismResponse& response);

}  // namespace camlaw::problems
