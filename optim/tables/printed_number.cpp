// SPDX-License-Identifier: MIT
#include "optim/tables/printed_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace camlaw::optim {
namespace {

constexpr double kTieSlack = 1e-9;        // of a unit
constexpr double kLargestCount = 9.0e15;  // units; below 2^53, where a double still counts by one
/// Scaling by a power of ten and adding a half round by less.
constexpr double kLastBits = 4.0 * std::numeric_limits<double>::epsilon();

double units_per_one(int decimals) {
  assert(decimals >= 0 && decimals <= kMaxDecimals);
  static constexpr std::array<double, kMaxDecimals + 1> kPowers{
      1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  return kPowers[static_cast<std::size_t>(decimals)];
}

/// How far, in units, a value may lie beyond an exact half and still count as that half.
double slack(double units) { return kTieSlack + kLastBits * std::abs(units); }

/// Digits that the print shows for this many units: 0.04 has two decimals and shows three digits.
int shown_digits(std::int64_t units, int decimals) {
  int digits = 0;
  for (; units != 0; units /= 10) ++digits;
  return std::max(digits, decimals + 1);
}

/// `a` and `b` count units without sign and show equally many digits.
bool one_digit_differs(std::int64_t a, std::int64_t b) {
  int differing = 0;
  int vouching = 0;
  for (; a != 0 || b != 0; a /= 10, b /= 10) ++(a % 10 == b % 10 ? vouching : differing);
  return differing == 1 && vouching > 0;
}

bool misprinted(std::int64_t print, double ours, int decimals) {
  const auto rounded = static_cast<std::int64_t>(ours);
  if ((print < 0) != (rounded < 0)) return false;
  return shown_digits(print, decimals) == shown_digits(rounded, decimals) &&
         one_digit_differs(std::abs(print), std::abs(rounded));
}

}  // namespace

bool agrees(PrintedNumber print, double ours) {
  if (!std::isfinite(print.value) || !std::isfinite(ours)) return false;
  const double scale = units_per_one(print.decimals);
  return std::abs(ours - print.value) * scale <= 0.5 + slack(print.value * scale);
}

std::string as_printed(double value, int decimals) {
  assert(decimals >= 0 && decimals <= kMaxDecimals);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool shows_zero = text.find_first_not_of("-0.") == std::string::npos;
  if (shows_zero && text.front() == '-') text.erase(0, 1);
  return text;
}

bool one_digit_misprint(PrintedNumber print, double ours) {
  const double scale = units_per_one(print.decimals);
  const double printed = std::round(print.value * scale);
  const double units = ours * scale;
  // Negated, so that NaN is refused with infinity and with what a double cannot count.
  if (!(std::abs(printed) < kLargestCount && std::abs(units) < kLargestCount)) return false;
  if (agrees(print, ours)) return false;
  const auto count = static_cast<std::int64_t>(printed);
  const double half = 0.5 + slack(units);
  return misprinted(count, std::floor(units + half), print.decimals) ||
         misprinted(count, std::ceil(units - half), print.decimals);
}

}  // namespace camlaw::optim
