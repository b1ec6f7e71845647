// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace camlaw::cli {

/// Rows of values as CSV (RFC 4180 quoting, first row the header). Text that a spreadsheet would
/// take for a formula, "=..." and the like, gets an apostrophe before it.
std::string to_csv(const std::vector<std::vector<std::string>>& rows);

/// A number for people: `decimals` places, "inf", "-inf" or "-" for NaN, never "-0.00".
std::string shown(double value, int decimals);
/// A number for people: as many digits as 7 of `size`, that of the numbers it stands beside, so
/// that their rounding is not shown; at most `digits` of its own; never "-0", nor 2e+04.
std::string significant(double value, double size, int digits = 7);
/// A number for people: so many significant digits, never "-0"; below a million no power of ten.
std::string in_digits(double value, int digits = 7);
/// A name of the program for readers: "peak_pressure_angle" as "peak pressure angle".
std::string plain_name(std::string_view name);
/// A unit as it stands beside numbers: nothing for that of plain numbers, "1".
std::string shown_unit(const std::string& unit);
/// "40 mm", of a plain number "40".
std::string with_unit(const std::string& text, const std::string& unit);
/// A number for programs: as many digits as bring the same double back; "inf", "-inf", and nothing,
/// an empty cell, for what is not a number.
std::string exact(double value);

}  // namespace camlaw::cli
