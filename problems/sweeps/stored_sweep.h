// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/study/recorded_executor.h"
#include "problems/sweeps/sweep_study.h"

namespace camlaw::problems {

/// The sweep that a record holds, as far as it is believed (docs/problem-files.md, "What a record
/// is worth").
struct StoredSweep {
  SweptCombinations sweep;
  std::vector<optim::RecordFault> faults = {};  ///< tasks that do not count
  std::vector<std::string> notes = {};          ///< what is to be said of the record, in sentences
};

/// Without a search.
StoredSweep stored_sweep(const SweepStudy& study, optim::StudyRecord& record);

}  // namespace camlaw::problems
