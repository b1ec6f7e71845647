// SPDX-License-Identifier: MIT
#include "problems/fronts/stored_front.h"

#include <fmt/format.h>

#include <algorithm>

#include "optim/pareto/judged_again.h"

namespace camlaw::problems {
namespace {

using optim::FrontPoint, optim::Verdict;

bool is_good(const FrontPoint& point) {
  return point.verdict == Verdict::Certified || point.verdict == Verdict::Feasible;
}

/// Whose verdicts a record's are: empty where they are this program's own.
std::string other_version(const FrontStudy& study, const optim::StudyRecord& record) {
  const std::string mine = study.settings().at("versions");
  const optim::StudySettings settings = record.settings();
  const auto its = settings.find("versions");
  if (!record.has_checksums()) return "an earlier version, whose rows have no checksums";
  if (its == settings.end()) return "an unknown version";
  return its->second == mine ? "" : its->second;
}

/// The designs with their verdicts as this program finds them; those that it finds to be none are
/// left out.
std::vector<FrontPoint> judged(const FrontStudy& study, const std::vector<FrontPoint>& designs) {
  const optim::ProblemSpace& space = study.space();
  std::vector<FrontPoint> result;
  for (const FrontPoint& point : designs) {
    FrontPoint now = optim::judged_again(space.problem(space.options(point.part)), point);
    if (is_good(now)) result.push_back(std::move(now));
  }
  return result;
}

std::size_t certified(const std::vector<FrontPoint>& points) {
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const auto& p) { return p.verdict == Verdict::Certified; }));
}

/// Of all that is believed, whether the study came to ask for it or not.
optim::Front front_of_believed(const FrontStudy& study, const std::vector<optim::Outcome>& all) {
  std::vector<FrontPoint> designs;
  long evaluations = 0;
  for (const optim::Outcome& outcome : all) {
    designs.insert(designs.end(), outcome.points.begin(), outcome.points.end());
    evaluations += outcome.evaluations;
  }
  optim::Front front = optim::front_of_designs(study.space(), study.options(), designs);
  front.tasks = all.size();
  front.evaluations = evaluations;
  return front;
}

/// Puts the verdicts of this program in the place of those that are stored.
void judge_anew(const FrontStudy& study, const std::string& version, StoredFront& stored) {
  optim::Front& front = stored.front;
  std::vector<FrontPoint> points = judged(study, front.points);
  std::string found;
  if (certified(points) != certified(front.points)) {
    found = fmt::format(": {} of its points are certified, not {} as it says", certified(points),
                        certified(front.points));
  }
  stored.notes.push_back(
      fmt::format("the study was made by {}; its designs are judged again{}", version, found));
  if (points.size() < front.points.size()) {
    stored.notes.push_back(fmt::format("{} of its points do not meet their limits and are left out",
                                       front.points.size() - points.size()));
    const auto [tasks, evaluations] = std::pair(front.tasks, front.evaluations);
    front = optim::front_of_designs(study.space(), study.options(), points);
    front.tasks = tasks, front.evaluations = evaluations;
    return;
  }
  front.points = std::move(points);
  front.each_is_global = false;  // of searches that found nothing there is nothing to judge
}

std::string fault_words(const optim::RecordFault& fault, const std::string& then) {
  using Kind = optim::RecordFault::Kind;
  const std::string why = fault.kind == Kind::Damaged
                              ? "its rows were changed after they were written"
                          : fault.kind == Kind::Lost ? "its row is missing"
                                                     : fault.why;
  return fmt::format("task {} is {}: {}; {}", fault.task, to_string(fault.kind), why, then);
}

}  // namespace

std::vector<std::string> fault_notes(const std::vector<optim::RecordFault>& faults,
                                     const std::string& then) {
  std::vector<std::string> notes;
  for (const optim::RecordFault& fault : faults) notes.push_back(fault_words(fault, then));
  return notes;
}

StoredFront stored_front(const FrontStudy& study, optim::StudyRecord& record) {
  optim::RecordedExecutor recorded(study.space(), record, nullptr);
  StoredFront stored{.front = study.run(recorded)};
  const std::string version = other_version(study, record);
  // Another version may have asked for other tasks than this one would: what it found counts.
  if (!recorded.faults().empty() || (!version.empty() && stored.front.stopped)) {
    stored.front = front_of_believed(study, recorded.believed());
  }
  stored.faults = recorded.faults();
  if (record.lost_log()) stored.notes.emplace_back(kLostLog);
  if (!version.empty()) judge_anew(study, version, stored);
  stored.resuming = version.empty() ? Resuming::Works : Resuming::Refused;
  const std::string then = version.empty() ? "--resume solves it again" : "it does not count";
  for (std::string& note : fault_notes(stored.faults, then)) {
    stored.notes.push_back(std::move(note));
  }
  return stored;
}

}  // namespace camlaw::problems
