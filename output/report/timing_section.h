// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/report/page.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// A part of a cam's motion over the angle of the shaft, which may go over the end of the turn:
/// then `to` is above 360.
struct TimedSpan {
  enum class Kind : char { Rise, Return, Dwell };
  std::string name;
  Kind kind;
  double from, to;  ///< deg; from within 0 to 360
};

/// Of one cam of a design with several on one shaft; none where no program moves it.
std::vector<TimedSpan> timed_spans(const problems::ProblemStatement& design, std::size_t cam);

/// Of the one motion of a design that a program moves; none of several cams, or without a program.
std::vector<TimedSpan> motion_spans(const problems::ProblemStatement& design);
/// The same as page.js takes them.
Json spans_json(const std::vector<TimedSpan>& spans);

/// The timing diagram of several cams on one shaft: a row for each, with its rises, dwells and
/// returns as bars and its displacement as a line; none for one machine.
std::optional<ReportSection> timing_section(const problems::ProblemStatement& design);

}  // namespace camlaw::cli
