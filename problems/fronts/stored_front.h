// SPDX-License-Identifier: MIT
#pragma once

#include "optim/study/recorded_executor.h"
#include "problems/fronts/front_study.h"

namespace camlaw::problems {

/// What becomes of a front that is not finished.
enum class Resuming {
  NoRecord,  ///< nothing was recorded: it is searched for anew
  Works,     ///< 'pareto --resume' goes on with it
  Refused,   ///< its record is of another version of the program, and only shown
};

/// The front that a record holds, as far as it is believed (docs/problem-files.md, "What a record
/// is worth").
struct StoredFront {
  optim::Front front;
  std::vector<optim::RecordFault> faults = {};  ///< tasks that do not count
  std::vector<std::string> notes = {};          ///< what is to be said of the record, in sentences
  Resuming resuming = Resuming::NoRecord;
};

/// Without a search. Tasks that are damaged or wrong do not count; where there are any, the front
/// is that of all other designs of the record, and counts as not finished. The designs of another
/// version of the program are judged anew.
StoredFront stored_front(const FrontStudy& study, optim::StudyRecord& record);

/// What to say of a record that was read without its log.
inline constexpr const char* kLostLog =
    "the program that wrote the study was killed, and its log, the file ending in -wal, is not "
    "beside it: the last searches are lost unless the log is put back";

/// What to say of tasks that are not believed, a sentence for each; `then`: what becomes of them.
std::vector<std::string> fault_notes(const std::vector<optim::RecordFault>& faults,
                                     const std::string& then);

}  // namespace camlaw::problems
