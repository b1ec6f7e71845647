// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/constants/agreement.h"
#include "fitting/constants/printed_model.h"

namespace camlaw::problems {

/// A coefficient or size that was found.
struct FoundNumber {
  std::string name, unit;
  bool of_law = true;
  double value = 0;          ///< the simplest that agrees with the prints
  double low = 0, high = 0;  ///< between which all agree, the others free
  bool identifiable = true;  ///< the prints determine it; not where others were found to agree
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
  /// Laws of other names that explain the print no shorter and are the same motion.
  std::vector<Member> also = {};
};

/// Digits that it takes to write constants down, where nothing explains them.
double cost_of(const PrintedConstant& constant);
double cost_of(const std::vector<PrintedConstant>& constants);

/// A solution, with which the constants `agreeing` do agree, written as shortly as it goes: each
/// unknown in turn at the simplest value that leaves the others values to agree with. None where it
/// costs more than `limit`. What other solutions have other values of is not determined.
std::optional<ConstantsFit> shortest(const PrintedModel& model,
                                     const std::vector<std::size_t>& agreeing,
                                     const AgreeingValues& solution,
                                     std::span<const AgreeingValues> all, double limit);
/// What was found with the law's coefficients held, with these among its numbers: the ranges of
/// all in which the same constants agree. `model` has the law's coefficients and the machine's
/// variables as unknowns.
ConstantsFit with_ranges(const PrintedModel& model, ConstantsFit fit);
/// Of the default values, whether the constants agree or not.
ConstantsFit as_it_is(const PrintedModel& model);

}  // namespace camlaw::problems
