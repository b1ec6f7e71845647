// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/answers/design_value.h"

namespace camlaw::cli {

/// A line for each value from one on, "  base_radius = 49.2 mm", without that of a name; a long
/// list has one line for all its numbers.
std::string value_lines(const std::vector<DesignValue>& values, std::size_t from,
                        const std::string& left_out);

}  // namespace camlaw::cli
