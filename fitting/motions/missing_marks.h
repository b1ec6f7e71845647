// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "numerics/tables/sample_table.h"

/// Numbers that stand for no number, such as -9999.
namespace camlaw::problems {

/// Why a column cannot be of measured values alone: three rows or more, but no more than half, hold
/// one and the same value, which lies farther from all others than one and a half times their whole
/// range. In words with the lines; empty where nothing shows it. `lines`: of the file, of each row;
/// or none.
std::string marks_of_missing(const SampleColumn& column, const std::vector<std::uint32_t>& lines);

}  // namespace camlaw::problems
