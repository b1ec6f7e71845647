// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/exported_curve.h"
#include "problems/statement/statement.h"

/// What a tool can follow, and what keeps it from that.
namespace camlaw::problems {

/// What keeps a tool from going along a curve, in words: first that it turns back, of which jumps
/// may be the mere consequence.
std::vector<std::string> obstacles(const PlaneCurve& curve);

/// What the roller along the pitch curve and the tool along the cutter path cut of the profiles
/// that are to stay, in words: a hollow is too narrow for them although they fit where they touch.
std::vector<std::string> cuts_into_profiles(const std::vector<PlaneCurve>& curves);

/// A curve of a design that a tool can go along: G-code is made of nothing else.
class ToolPath {
 public:
  /// Throws std::invalid_argument, with the first obstacle, for a curve that has some, and for a
  /// cam one of whose profiles has, or is cut into: the path of a tool as large as the roller is
  /// smooth where the profile that it leaves is undercut, and the follower would not move as it
  /// should.
  ToolPath(const ProblemStatement& design, const PlaneCurve& curve, CurveForm form,
           const ExportAccuracy& accuracy);

  const ExportedCurve& exported() const { return exported_; }
  /// What of this was looked at but is not proved, in words.
  const std::vector<std::string>& doubts() const { return doubts_; }

 private:
  ExportedCurve exported_;
  std::vector<std::string> doubts_;
};

}  // namespace camlaw::problems
