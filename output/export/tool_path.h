// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/exported_curve.h"
#include "problems/statement/statement.h"

namespace camlaw::problems {

/// What keeps a tool from going along a curve, in words: first that it turns back, of which jumps
/// may be the mere consequence.
std::vector<std::string> obstacles(const PlaneCurve& curve);

/// A curve of a design that a tool can go along: G-code is made of nothing else.
class ToolPath {
 public:
  /// Throws std::invalid_argument, with the first obstacle, for a curve that has some, and for a
  /// cutter's path beside a profile that has: the path of a tool as large as the roller is smooth
  /// where the profile that it leaves is undercut, and the follower would not move as it should.
  ToolPath(const ProblemStatement& design, const PlaneCurve& curve, CurveForm form,
           const ExportAccuracy& accuracy);

  const ExportedCurve& exported() const { return exported_; }

 private:
  ExportedCurve exported_;
};

}  // namespace camlaw::problems
