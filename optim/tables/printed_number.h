// SPDX-License-Identifier: MIT
#pragma once

/// A number as a source prints it, and whether a computed value agrees with that print.
///
/// The unit of a print is 10^-decimals: 8.91 (two decimals) stands for anything from 8.905
/// to 8.915. Values carry the print's own physical unit. No function here throws; decimals outside
/// [0, kMaxDecimals] are a programmer's error.

#include <string>

namespace camlaw::optim {

/// A double carries 15 decimal digits faithfully.
inline constexpr int kMaxDecimals = 15;

/// `value` as printed with `decimals` digits after the point; 0 for a print such as "50".
struct PrintedNumber {
  double value = 0.0;
  int decimals = 0;
};

/// True if |ours - value| is at most half a unit. An exact half may be rounded either way, so both
/// directions agree (slack: 1e-9 unit, and the last bits of a large value). NaN and infinity never
/// agree.
bool agrees(PrintedNumber print, double ours);

/// `value` rounded to `decimals` digits, never "-0.00". NaN and infinity give "nan" and "inf".
std::string as_printed(double value, int decimals);

/// True if one wrong digit turns `ours` into the print: rounded to the print's decimals (an exact
/// half either way), it has the same sign and as many digits, and exactly one digit differs.
/// Another significant digit must be left to vouch for it: any digit would be a "misprint" of the
/// print "5". 58.97 for 59.97 is one; 34.55 for 34.64 (two digits) and 9.9 for 10.0 (length) are
/// not.
bool one_digit_misprint(PrintedNumber print, double ours);

}  // namespace camlaw::optim
