// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fitting/constants/printed_constants.h"
#include "kinematics/peaks.h"
#include "machines/model/law_binding.h"

namespace camlaw::problems {

/// A peak constant of a law: the highest, lowest or largest size of s', s'', s''' or s' s''.
struct LawConstant {
  Quantity quantity;
  optim::Part part;
  /// Whether jumps make it infinite, as VDI 2143 counts them; else it is of the smooth pieces,
  /// which tables print as "12 (inside)". Of the jerk alone: the rest is not told apart.
  bool counts_jumps;
};

/// The peak constant that a print is of, where it is one. An infinite print counts jumps, a finite
/// one does not.
std::optional<LawConstant> law_constant(const PrintedConstant& printed);

/// Numbers that depend on a design, with their derivatives.
struct ConstantsAt {
  std::vector<double> values;
  std::vector<double> slopes;  ///< by every variable of the design, constant by constant
};

/// Peak constants at a design, all from the same exact peaks (kinematics/peaks.h). NaN where the
/// design makes no law.
ConstantsAt law_constants(std::span<const LawConstant> constants, const LawBinding& law,
                          std::span<const double> design);

}  // namespace camlaw::problems
