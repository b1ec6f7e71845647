// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "output/export/exported_curve.h"
#include "output/export/plane_curve.h"

/// How large a tool may be that a controller leads beside a profile.
namespace camlaw::problems {

/// Tools of every radius up to this one fit beside a profile. What a tool may not be is told by the
/// place where a larger one cuts, deg; none: the largest that was asked for fits.
struct LargestTool {
  double radius = 0;  ///< mm
  std::optional<double> cuts_at = {};
  bool proved = false;  ///< that no tool up to the radius cuts in
};

/// The largest tool up to `most`, mm, beside a profile on its outside: the least radius of its
/// hollows, or less where the tool would reach a place of the profile that it does not touch
/// (docs/theory.md, (EX9)). Found to a thousandth, from below. The profile must not turn back.
LargestTool largest_tool(const PlaneCurve& profile, double most);

/// The least radius of the arcs of a written profile that are hollow, in the curve's unit; infinite
/// where there is none. Controllers refuse a larger tool on such an arc.
double least_hollow_arc(const ExportedCurve& written, bool outside_is_left);

}  // namespace camlaw::problems
