// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// Fits of ISO 286, for sizes up to 500 mm: what a tolerance class such as "h7" allows a size.
namespace camlaw::problems {

/// A tolerance class: a fundamental deviation by its letter, a standard tolerance by its grade.
struct Fit {
  std::string_view letter;  ///< "h", "js"; capitals are holes
  int grade = 7;            ///< of IT
};

/// Between which deviations a size lies, mm.
struct FitDeviations {
  double lower, upper;
};

/// Reads "h7", "JS8". Throws std::invalid_argument with what is accepted for other letters and
/// grades.
Fit parse_fit(std::string_view text);

/// The standard tolerance of a grade from 5 to 11, mm, of a size in mm.
double standard_tolerance(int grade, double size);

/// The deviations of a size in mm. Throws std::invalid_argument for sizes that are not above 0 or
/// are above 500 mm.
FitDeviations fit_deviations(const Fit& fit, double size);

}  // namespace camlaw::problems
