// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "problems/fits/printed_constants.h"
#include "problems/statement/statement.h"

/// From printed constants back to what was computed with: the coefficients of a law, sizes of the
/// machine. Derivation and criterion: docs/optimisation.md, "Fits to printed constants".
namespace camlaw::problems {

/// The machine with what is known of it, and what is printed.
struct ConstantsQuestion {
  /// Mechanism and constants. Its variables that belong to the mechanism are unknown within their
  /// bounds; objectives and constraints do not matter.
  ProblemStatement machine;
  std::vector<PrintedConstant> constants;
};

/// The machine that is a law alone.
ProblemStatement law_alone();

/// A coefficient or size that was found.
struct FoundNumber {
  std::string name, unit;
  bool of_law = true;
  double value = 0;          ///< the simplest that agrees with the prints
  double low = 0, high = 0;  ///< between which all agree, the others free
  bool identifiable = true;  ///< the prints determine it at all
};

struct AgreeingConstant {
  PrintedConstant printed;
  double value = 0;  ///< with the numbers that were found
  bool agrees = false;
};

/// What one law makes of the prints.
struct ConstantsFit {
  Member law;  ///< with the simplest coefficients
  std::vector<FoundNumber> numbers;
  std::vector<AgreeingConstant> constants;
  /// Digits that it takes to write the numbers that were found, each with one for its being there,
  /// and the constants that do not agree: the less, the better the law explains the print.
  double cost = 0;
  bool consistent = false;    ///< all constants agree
  bool identifiable = false;  ///< all numbers are determined
};

/// With one law: its coefficients but the crossover and what shapes its data are unknown. The best
/// first; several where the prints leave several. Where no values agree with all prints, those that
/// agree with the most.
std::vector<ConstantsFit> fit_constants(const ConstantsQuestion& question, const Member& law);

/// With each of the laws, the best of all first. Laws with more unknowns than there are constants
/// are left out: they can be made to agree with anything.
std::vector<ConstantsFit> rank_laws(const ConstantsQuestion& question,
                                    const std::vector<Member>& laws);

/// The laws of the catalogue from rest or to it, each with its standard coefficients.
std::vector<Member> laws_to_try();

}  // namespace camlaw::problems
