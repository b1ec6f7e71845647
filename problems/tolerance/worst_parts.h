// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/tolerance/varied_design.h"

/// The worst that manufacture makes of a limit: over all values that its variations reach, and all
/// angles, at once (docs/theory.md, "Ranges of parameters").
namespace camlaw::problems {

/// What is known of a limit over all parts.
enum class Holds : char {
  Proved,     ///< it holds for every part, proved by intervals
  Broken,     ///< a part is known that breaks it
  NotProved,  ///< no part is known that breaks it, and nothing shows that there is none
};
std::string_view to_string(Holds holds);

/// One side of a limit.
struct WorstPart {
  std::size_t limit = 0;  ///< of the design's
  std::string name, unit;
  bool is_upper = true;
  double bound = 0;
  double value = 0;   ///< the worst that was found
  double slack = 0;   ///< nothing is worse by more, where that is proved; else infinite
  double margin = 0;  ///< of the value to the bound
  double tolerance = 0;
  std::optional<double> angle;  ///< of a curve
  std::vector<double> part;     ///< the values that it has there; not a number: any
  Holds holds = Holds::NotProved;
  std::string why_not = {};  ///< why it is not proved
};

/// Of each limit and each of its sides, as large as `share` of the variations.
std::vector<WorstPart> worst_parts(const VariedDesign& varied, double share = 1);

/// Of each number that varies the limits, increasing, that hold at the nominal part and that it
/// breaks by itself, at any of its values that a search finds.
std::vector<std::vector<std::size_t>> broken_alone(const VariedDesign& varied);

/// Parts that may be a hundred times as far off as stated are no longer the question.
inline constexpr double kLargestFactor = 100;

/// How far the variations may grow before a limit breaks.
struct BreakFactor {
  /// Times the variations as they are stated; infinite where it is above the largest that is tried,
  /// 0 where the nominal part breaks the limit.
  double factor = 0;
  bool proved = false;            ///< that the limit holds up to a hundredth less
  double tried = kLargestFactor;  ///< the largest factor, whose values the parameters accept
};
/// Of one side of a limit, as worst_parts has it at 1.
BreakFactor break_factor(const VariedDesign& varied, const WorstPart& worst);

}  // namespace camlaw::problems
