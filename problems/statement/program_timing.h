// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "problems/statement/statement.h"

/// Times of a motion program, as they are read.
namespace camlaw::problems {

struct Entry;

/// The mechanism's speed, rpm; none: it has no such parameter.
std::optional<std::size_t> speed_of(const Mechanism& mechanism);

/// Whether a program has times that stay at another speed, but holds the angles that they make at
/// the speed of the machine, or for one of the cams at that of their shaft: at another speed such a
/// program is another one.
bool holds_angles_of_speed(const ProblemStatement& problem);

/// Whether anything but a segment's whole time needs the time of a turn.
bool has_rates_by_time(const Entry& program);

/// What a program says of times: `cycle_time`, `times_at`, or times by the machine's `speed`. None
/// where it says nothing. A `cycle_time` sets the speed, unless the file states that too. Throws
/// std::invalid_argument where the two differ, where the speed varies and no speed is given at
/// which the times hold, and where there are times and neither.
/// Where times stay (Mechanism::keeps_times) the speed may vary, and differ between load cases.
std::optional<ProgramTiming> read_timing(const Entry& file, const Entry& program,
                                         ProblemStatement& problem);

}  // namespace camlaw::problems
