// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fitting/constants/constants_question.h"
#include "fitting/constants/explanation.h"

/// From printed constants back to what was computed with: the coefficients of a law, sizes of the
/// machine. Derivation and criterion: docs/optimisation.md, "Fits to printed constants".
namespace camlaw::problems {

/// With one law: its coefficients but the crossover and what shapes its data are unknown. The best
/// first; several where the prints leave several. Where no values agree with all prints, those that
/// agree with the most; none where not one constant can be made to agree.
std::vector<ConstantsFit> fit_constants(const ConstantsQuestion& question, const Member& law);

/// With each of the laws, the best of all first. Laws with more unknowns than there are constants,
/// which can be made to agree with anything, are tried with the coefficients that they have; they
/// are left out where the machine alone has more. So are explanations that take more than three
/// digits above the best found before them, those that leave constants out and are no shorter than
/// the print itself, and a motion that is there already under another name. Empty where nothing is
/// left.
std::vector<ConstantsFit> rank_laws(const ConstantsQuestion& question,
                                    const std::vector<Member>& laws);

/// The laws of the catalogue from rest or to it, each with its default coefficients.
std::vector<Member> laws_to_try();

}  // namespace camlaw::problems
