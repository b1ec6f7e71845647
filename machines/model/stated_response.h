// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "machines/model/cycle.h"
#include "machines/model/mechanism.h"
#include "numerics/formula/formula_text.h"

/// Responses that a person states as formulas, over what the mechanism has already.
namespace camlaw::problems {

struct StatedResponse {
  std::string name, unit, meaning;
  FormulaTree formula;
};

/// What the curves of a machine run over as a rule: of one that a law moves its abscissa, else a
/// turn.
Cycle usual_cycle(MovedBy moved_by);

/// Whether a name stands for something in every formula: s, v, a, j, x, angle, pi, and the
/// functions and words of formulas.
bool is_formula_word(const std::string& name);

/// What a response's formula holds of these names: for an order in which they can be made.
std::vector<std::string> names_held(const FormulaTree& formula,
                                    const std::vector<std::string>& names);

/// The response, a curve where the formula holds the motion, the angle or a curve, else a number;
/// `mechanism` has whatever else the formula names, by a parameter's name or symbol, a response's,
/// or "peak", "highest" or "lowest" and a curve. In the formula all are counted in the units of the
/// SI, angles in rad. Throws std::invalid_argument with the place in the formula of names that are
/// not known and of units that do not go together.
MechanismResponse stated_response(const Mechanism& mechanism, StatedResponse stated);

}  // namespace camlaw::problems
