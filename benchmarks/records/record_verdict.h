// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "benchmarks/records/simulated_record.h"

/// What a fit says of a record whose law is known.
namespace camlaw::benchmarks {

struct RecordVerdict {
  std::uint64_t number = 0;
  std::string truth, named;  ///< laws as the program prints them
  double noise = 0;          ///< with the rounding, over the stroke or the peak
  double step = 0;           ///< what values are rounded to over the noise
  int order = 0;
  bool is_one_motion = false;  ///< found as the one motion that it is; nothing below where not
  bool is_right = false;       ///< the named law is the record's
  bool is_among = false;       ///< that, or one of those as good is
  bool trusted = false;
  std::string reason;       ///< where not
  std::size_t as_good = 0;  ///< laws named beside the first
  /// Of begin, end, stroke and zero (not of derivatives): whether the interval holds the truth, and
  /// how wide it is over that of the true law fitted alone; none where there is no interval.
  std::array<std::optional<bool>, 4> held;
  std::array<std::optional<double>, 4> width;
  double milliseconds = 0;
};

/// Fits the record as `camlaw fit` does, every law. A law is right where the curve that was fitted
/// lies within the noise of the true one (root of the mean square at the samples) and its family
/// holds the true law, which a fit to the motion without noise tells.
RecordVerdict verdict_of(std::uint64_t number, Disturbance disturbance = Disturbance::None);

/// A verdict as a line of a file, and back. Throws std::invalid_argument for another line.
std::string line_of(const RecordVerdict& verdict);
RecordVerdict verdict_of_line(const std::string& line);

}  // namespace camlaw::benchmarks
