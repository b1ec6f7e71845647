// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "machines/model/mechanism.h"

/// Numbers as tables and drawings print them: a rounded number is an interval, not a point.
namespace camlaw::problems {

/// What is printed of a quantity. Any value from low to high is printed so: half a unit of the last
/// digit to either side, or as far as stated.
struct PrintedConstant {
  std::string name;               ///< as asked for
  std::string text;               ///< as printed, "35.56 mm"
  const Mechanism* of = nullptr;  ///< whose response it is: the machine's, or the law's own
  ResponseName response;
  double value = 0, low = 0, high = 0;  ///< in the response's listed unit; infinite alike
  int digits = 0;                       ///< significant digits that are printed
};

/// Reads "C_v=1.6125, C_a=4.66, minimum_cam_radius=35.56 mm"; "C_a=7.03 +- 0.05" states how far a
/// value may be off. Names are responses of `machine` (with "peak", "highest" or "lowest" before
/// curves), or of the law itself: C_v, C_a, C_j, C_Mdyn, C_a_max, C_a_min, C_j_max, C_j_min and
/// what else mechanism "law" has. A word that is part of one response's name alone stands for it:
/// "radius". Throws std::invalid_argument that names the constant and what is accepted.
std::vector<PrintedConstant> parse_constants(std::string_view text, const Mechanism& machine);

}  // namespace camlaw::problems
