// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// Numbers as people write them, with units, through udunits: "40 mm", "30deg", "300 rpm".
namespace camlaw::problems {

/// The value of `text` in `unit` (udunits spelling, also deg and rpm; "1" for a plain number). A
/// number without a unit is taken in `listed`, the unit that the quantity is listed in. `what`
/// names the quantity in errors. Throws std::invalid_argument where the number or unit cannot be
/// read or is of another kind ("stroke: '30 deg' is an angle, a length is wanted, such as 40 mm").
double parse_quantity(std::string_view text, const std::string& unit, const std::string& listed,
                      const std::string& what);

/// A value in one unit, converted to another of the same kind.
double convert_unit(double value, const std::string& from, const std::string& to);

}  // namespace camlaw::problems
