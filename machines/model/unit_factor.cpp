// SPDX-License-Identifier: MIT
#include "machines/model/unit_factor.h"

#include "numerics/text/units.h"

namespace camlaw::problems {

UnitFactor::UnitFactor(const std::string& from, const std::string& to)
    : factor_(convert_unit(1, from, to)) {}

}  // namespace camlaw::problems
