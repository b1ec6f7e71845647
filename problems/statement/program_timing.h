// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

/// Times of a motion program. A cam that is cut has angles: a time becomes one once, when the file
/// is read, by how long a turn takes then.
namespace camlaw::problems {

struct Entry;
struct ProblemStatement;

/// A turn, and what takes a stated time of it.
struct ProgramTiming {
  struct Segment {
    std::string name;
    double time;  ///< s
  };

  double speed = 0;               ///< at which the times hold, rpm
  std::vector<Segment> segments;  ///< those that the file states in time

  /// A turn, s: 60 s / (speed in rpm).
  double turn() const { return 60 / speed; }
  /// Of the cam, deg.
  double angle_of(double time) const { return time / turn() * 360; }
};

/// What a program says of times: `cycle_time`, `times_at`, or times by the machine's `speed`. None
/// where it says nothing. A `cycle_time` sets the speed, unless the file states that too. Throws
/// std::invalid_argument where the two differ, where the speed varies and no speed is given at
/// which the times hold, and where there are times and neither.
std::optional<ProgramTiming> read_timing(const Entry& file, const Entry& program,
                                         ProblemStatement& problem);

}  // namespace camlaw::problems
