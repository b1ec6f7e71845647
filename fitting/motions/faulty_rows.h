// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fitting/samples/motion_samples.h"
#include "numerics/tables/turn.h"

/// Rows of a record that are slips of the pen or of the instrument.
namespace camlaw::problems {

/// A turn of angles that a table prints with some digits, deg: longer ones come round again.
inline constexpr double kLongestTurn = kTurnDegrees * (1 + 1e-6);

/// A row that was left out.
struct FaultyRow {
  std::size_t line = 0;  ///< of the file, from 1; 0 where it is not known
  double place = 0, value = 0;
  double distance = 0;  ///< of its value from the curve that the others make, or of its place from
                        ///< the nearest other one
};

/// A motion's samples as they were recorded.
struct MotionRecord {
  MotionSamples samples;
  std::vector<std::uint32_t> lines = {};  ///< of the file, of each sample; empty where not known
  std::vector<FaultyRow> stray = {};      ///< whose places lie far from all others, by place
  std::vector<FaultyRow> far = {};        ///< whose values lie off their neighbours, by distance
  std::vector<std::string> notes = {};    ///< what was assumed in reading, in words
};

/// Leaves out rows whose place a gap parts from all others that is ten times as long as these reach
/// (of angles also those that make the record longer than a turn and stand three usual steps
/// apart): at most one in twenty, or one.
void leave_out_stray_places(MotionRecord& record);

/// Leaves out rows whose value lies farther off the curve of their neighbours than chance explains
/// ((FS4) in docs/optimisation.md): of 24 samples and more by a robust smoothing spline, of nine
/// and more one row without which a cubic through neighbours misses none by an eighth as much.
/// `period` as in find_motions.
void leave_out_far_values(MotionRecord& record, double period);

/// Takes rows back in of those whose values lay off their neighbours; returns how many.
std::size_t put_back(MotionRecord& record, const std::function<bool(const FaultyRow&)>& is_good);

/// Whether so few rows of so many lie off that the others can be relied upon: one in fifty, or
/// three.
bool are_few(std::size_t off, std::size_t rows);

}  // namespace camlaw::problems
