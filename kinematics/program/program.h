// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"

/// Motion programs: a whole cycle of dwells, rises and returns (docs/theory.md, "Motion programs").
/// A program is a law like any other, s(x) over the cycle x from 0 to 1 in parts of the stroke; so
/// peaks, enclosures, derivatives by parameters and everything else hold for it too.
namespace camlaw {

/// A segment as a person states it.
struct ProgramSegment {
  std::string name;  ///< "rise": parameters are called by it, "rise_angle", "rise_alpha"
  double angle;      ///< of the cycle's 360 deg
  double to;         ///< displacement at its end, in parts of the stroke
  bool rests = false;
  std::optional<Member> law = {};  ///< none, and it does not rest: it joins its neighbours
};

/// What must be continuous where segments meet.
enum class Matched { Displacement = 0, Velocity = 1, Acceleration = 2 };

/// The program as a member of a family of its own, "program", whose parameters are the angles of
/// all segments but the last (NAME_angle, deg), the displacements at the ends of those that move
/// but the last such (NAME_to) and every parameter of their laws (NAME_alpha). Displacement begins
/// where the last segment leaves it. Its words, the family's formula, are those of the segments as
/// stated; Member::listed() is the same program in the words of its arguments.
///
/// Throws std::invalid_argument: names that are none or not different, angles that are not above 0
/// or do not add up to 360, and where segments do not meet as `matched` asks: "motion program:
/// where 'rise' meets 'dwell', at 120 deg, the acceleration jumps from -59.2 to 0 strokes per
/// cycle^2". Parameters at which they do not meet make no law.
Member motion_program(std::vector<ProgramSegment> segments, Matched matched);

}  // namespace camlaw
