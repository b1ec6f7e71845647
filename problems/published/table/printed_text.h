// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "optim/tables/printed_number.h"

namespace camlaw::problems {

/// A number as it stands in print, with its unit.
struct PrintedText {
  optim::PrintedNumber number;
  std::string unit;  ///< as written; empty where there is none
};

/// Reads "12.34 mm", "-0.50", "1.2e-3 m": the digits behind the point are the decimals. Throws
/// std::invalid_argument for what is not a number, for a comma, and where the decimals would be
/// below 0 ("1.2e3") or above optim::kMaxDecimals.
PrintedText read_printed_text(std::string_view text);

}  // namespace camlaw::problems
