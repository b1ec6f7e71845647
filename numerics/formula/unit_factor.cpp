// SPDX-License-Identifier: MIT
#include "numerics/formula/unit_factor.h"

#include "numerics/text/units.h"

namespace camlaw {

UnitFactor::UnitFactor(const std::string& from, const std::string& to)
    : factor_(convert_unit(1, from, to)) {}

}  // namespace camlaw
