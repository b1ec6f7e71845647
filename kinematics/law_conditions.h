// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/law.h"

namespace camlaw {

/// What another law must be like to take a law's place.
struct LawConditions {
  int continuity = 2;  ///< s .. s^(continuity) do not jump inside; 0 to 2
  bool rest[2][2] = {{true, true},
                     {true, true}};  ///< [at end][k]: whether s^(k + 1) vanishes there
};

/// The conditions that a law itself meets, to rounding.
LawConditions conditions_of(const Law<double>& law);
/// The conditions that are in both.
LawConditions shared_conditions(const LawConditions& a, const LawConditions& b);
bool meets(const Law<double>& law, const LawConditions& conditions);

}  // namespace camlaw
