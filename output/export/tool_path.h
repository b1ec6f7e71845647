// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/exported_curve.h"
#include "problems/statement/statement.h"

/// What a tool can follow, and what keeps it from that.
namespace camlaw::problems {

/// What keeps a tool from going along a curve, in words and in the curve's unit: first that it
/// turns back, of which jumps may be the mere consequence.
std::vector<std::string> obstacles(const PlaneCurve& curve);

/// What the roller along the pitch curve and the tool along the cutter path cut of the profiles
/// that are to stay, in words with lengths in `unit`: a hollow is too narrow for them although they
/// fit where they touch. The curves are in mm.
/// `doubts`, if wanted, gets what was looked at without being proved.
std::vector<std::string> cuts_into_profiles(const std::vector<PlaneCurve>& curves,
                                            const LengthUnit& unit = kMillimetre,
                                            std::vector<std::string>* doubts = nullptr);

/// How the tool comes to a path and leaves it: a quarter of a circle that is tangent to the path,
/// on its outside.
struct ToolLead {
  ArcPiece in, out;
  /// Where a straight move to the beginning of `in` begins, and one from the end of `out` ends: as
  /// long as the radius, for controllers that there begin and end to compensate for the tool.
  Eigen::Vector2d from, to;
  bool outside_is_left = false;
};

/// A curve of a design that a tool can go along: G-code is made of nothing else.
class ToolPath {
 public:
  /// Throws std::invalid_argument, with the first obstacle, for a curve that has some, and for a
  /// cam one of whose profiles has, or is cut into: the path of a tool as large as the roller is
  /// smooth where the profile that it leaves is undercut, and the follower would not move as it
  /// should.
  ToolPath(const ProblemStatement& design, const PlaneCurve& curve, CurveForm form,
           const ExportAccuracy& accuracy);

  /// Adds a lead of a radius, in the unit of the path. Throws std::invalid_argument where the tool
  /// would cut into a profile on it; along a profile it may be any tool smaller than the lead.
  void add_lead(const ProblemStatement& design, double radius);

  const ExportedCurve& exported() const { return exported_; }
  const std::optional<ToolLead>& lead() const { return lead_; }
  /// What of this was looked at but is not proved, in words.
  const std::vector<std::string>& doubts() const { return doubts_; }

 private:
  PlaneCurve curve_;  ///< in mm
  LengthUnit unit_;
  ExportedCurve exported_;
  std::optional<ToolLead> lead_ = {};
  std::vector<std::string> doubts_;
};

}  // namespace camlaw::problems
