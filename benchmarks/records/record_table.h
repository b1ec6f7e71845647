// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "benchmarks/records/record_verdict.h"

/// How honest fits are over many records.
namespace camlaw::benchmarks {

/// What is counted over a set of verdicts.
struct RecordTally {
  std::size_t records = 0, split = 0;        ///< all; those not found as one motion
  std::size_t right = 0, among = 0;          ///< of those that are one motion
  std::size_t trusted = 0, false_trust = 0;  ///< false: trusted, and the true law not among
  std::size_t intervals = 0, held = 0;       ///< of trusted records
  std::vector<double> widths, as_good;

  void add(const RecordVerdict& verdict);
};

/// The table of README.md.
std::string record_table(const std::vector<RecordVerdict>& verdicts);

/// Appends verdicts of the records [first, first + count) to a file, one a line, those that it has
/// left out: a run that was stopped goes on, and parts may go to files of their own.
void simulate_records(const std::string& file, std::uint64_t first, std::uint64_t count,
                      Disturbance disturbance = Disturbance::None);
/// Verdicts in such a file.
std::vector<RecordVerdict> read_verdicts(const std::string& file);

}  // namespace camlaw::benchmarks
