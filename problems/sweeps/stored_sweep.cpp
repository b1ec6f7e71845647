// SPDX-License-Identifier: MIT
#include "problems/sweeps/stored_sweep.h"

#include <fmt/format.h>

#include "problems/fronts/problem_settings.h"
#include "problems/fronts/stored_front.h"

namespace camlaw::problems {

StoredSweep stored_sweep(const SweepStudy& study, optim::StudyRecord& record) {
  optim::RecordedExecutor recorded(
      [&](std::size_t part, optim::Design x) { return study.problem(part, x); }, record, nullptr);
  StoredSweep stored{.sweep = study.run(recorded)};
  stored.faults = recorded.faults();
  if (record.lost_log()) stored.notes.emplace_back(kLostLog);
  const optim::StudySettings settings = record.settings();
  const std::string& versions = find_setting(settings, "versions");
  const bool is_same = versions == problem_versions();
  if (!is_same) {
    stored.notes.push_back(
        fmt::format("the study was made with {}; its verdicts are that program's", versions));
  }
  const std::string then = is_same ? "--resume solves it again" : "it does not count";
  for (std::string& note : fault_notes(stored.faults, then)) {
    stored.notes.push_back(std::move(note));
  }
  return stored;
}

}  // namespace camlaw::problems
