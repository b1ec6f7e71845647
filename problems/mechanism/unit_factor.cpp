// SPDX-License-Identifier: MIT
#include "problems/mechanism/unit_factor.h"

#include "problems/units.h"

namespace camlaw::problems {

UnitFactor::UnitFactor(const std::string& from, const std::string& to)
    : factor_(convert_unit(1, from, to)) {}

}  // namespace camlaw::problems
