// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

/// What [solver] of a file and the command line accept alike.
namespace camlaw::problems {

inline constexpr int kMostStarts = 1'000'000;
inline constexpr std::int64_t kMostSeed = std::numeric_limits<std::int64_t>::max();

/// "auto" or a solver's name, in any case, as it is listed. Throws std::invalid_argument with near
/// and known names.
std::string find_solver_name(std::string_view typed);

/// An integer from low to high; `what` names it in errors. Throws std::invalid_argument.
std::int64_t parse_integer(std::string_view text, std::int64_t low, std::int64_t high,
                           const std::string& what);

/// Seconds above zero: "30", "30 s", "1 min". Throws std::invalid_argument.
double parse_time_limit(std::string_view text, const std::string& what);

}  // namespace camlaw::problems
