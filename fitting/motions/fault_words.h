// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/faulty_rows.h"
#include "fitting/motions/record_faults.h"

/// Faults of a record in words.
namespace camlaw::problems {

/// A row as people look for it: "line 57 (30 deg) by 5 mm"; of a place that another sample has too
/// it says so.
std::string told(const FaultyRow& row, const MotionSamples& samples);

/// Why a motion is not trusted in which many rows lie off; the farthest first.
std::string many_far(const std::vector<FaultyRow>& rows, std::size_t of,
                     const MotionSamples& samples);

/// What the record shows, what it means and what helps, the likeliest fault first. `unit`: of the
/// samples; `can_centre`: --shift centre would fit the centre along, which it has not yet.
std::string fault_words(const std::vector<FaultTest>& seen, const std::string& unit,
                        bool can_centre);

}  // namespace camlaw::problems
