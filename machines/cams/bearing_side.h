// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/roller_contact.h"
#include "numerics/formula/expression.h"

/// Of two flanks or cams the one that bears the force between them (docs/theory.md, "Form
/// closure").
namespace camlaw {

/// (M27) What (M7) is for the outer flank of a groove, -r_r k: it is undercut where this reaches 1.
inline Expression outer_undercut(const RollerContact& roller, const Expression& k) {
  return roller.undercut(-k);
}

/// (M28) Greatest pressure, Pa, in a groove, on the flank that bears the force N, N: with the pitch
/// curve's curvature k, 1/m, the inner one where N is above 0 and the outer one, whose pitch curve
/// bends the other way, below. NaN where that flank is undercut.
inline Expression groove_stress(const RollerContact& roller, const Expression& force,
                                const Expression& k) {
  return unless_zero(force, roller.stress(absolute(force), by_side(force, k, -k)));
}

}  // namespace camlaw
