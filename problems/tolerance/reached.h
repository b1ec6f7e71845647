// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optim/problem/deadline.h"
#include "optim/verdict/assessment.h"
#include "problems/statement/statement.h"

/// What a design reaches of the reliabilities and robust objectives that it was searched for, by
/// parts of its own: those of a search favour what was found with them (docs/theory.md,
/// "Manufacturing tolerances").
namespace camlaw::problems {

/// What is known of a limit with a reliability.
enum class IsReached : char {
  Yes,         ///< the whole interval is within what is asked for
  No,          ///< the whole interval is beyond
  NotDecided,  ///< neither
};
std::string_view to_string(IsReached reach);

/// One side of a limit with a reliability.
struct ReachedShare {
  std::size_t limit = 0;  ///< of the statement's
  std::string name;
  double wanted = 0;            ///< share of all parts that are to hold it
  double share = 0;             ///< that do; not a number where the work was cut short
  optim::Bounds between{0, 1};  ///< of the share, at a confidence of 95 %
  IsReached reach = IsReached::NotDecided;
};

/// What is taken of an objective's values.
struct ReachedObjective {
  std::string name, unit;
  double value = 0;       ///< over as many parts as are told
  optim::Bounds between;  ///< at a confidence of 95 %
  std::size_t samples = 0;
  std::string cut_short = {};  ///< why it was not worked out; empty: it was
};

struct ReachedReliability {
  std::vector<ReachedShare> limits = {};
  std::optional<ReachedObjective> objective = {};
  std::size_t samples = 0;     ///< of each limit, no fewer
  std::string cut_short = {};  ///< why nothing is known of the limits; empty: it is

  /// Whether all limits are reached; true where there are none.
  bool all() const;
  /// "between 98.9 % and 99.1 % of all parts hold f, 99 % are asked for"; of the first limit that
  /// is not reached.
  std::string fault() const;
};

/// Of the parts that judge a design; neither those of a search nor, unless it is asked for, those
/// of `camlaw tolerance` are of this seed.
inline constexpr std::uint64_t kJudgesSeed = 20;

/// Whether a problem has reliabilities or a robust objective, so that its design is judged.
bool is_judged(const ProblemStatement& problem);

/// Of the design that a statement begins with; empty where it has neither. A variation of the law's
/// own parameters does not count, as in the search.
ReachedReliability reached_by(const ProblemStatement& design,
                              const optim::Deadline& deadline = optim::Deadline({}, nullptr),
                              std::uint64_t seed = kJudgesSeed);

/// The same of a design that is verified, by what it reaches.
std::function<void(optim::Assessment&)> held_to_parts(const ProblemStatement& design);

/// A verdict that says no more than is reached: of a design that meets its limits, but is not known
/// to reach every reliability, Failed with the fault as its reason.
void hold_to(const ReachedReliability& reached, optim::Assessment& assessment);

}  // namespace camlaw::problems
